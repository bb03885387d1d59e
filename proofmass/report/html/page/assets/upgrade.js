// SPDX-License-Identifier: Apache-2.0
// Replaces the drawn figures by ones that can be zoomed, read and saved. Without it the page is complete.
(() => {
  'use strict';
  const text = (id) => document.getElementById(id).textContent;
  const bytes = (base64) => Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const data = JSON.parse(text('figure-data'));
  const column = (packed) => {
    const buffer = bytes(packed.slice(1)).buffer;
    return Array.from(packed[0] === 'd' ? new Float64Array(buffer) : new Float32Array(buffer));
  };
  const columns = data.columns.map(column);
  const chinese = () => document.getElementById('lang-zh').checked;
  // The library takes markup and entities in texts: what comes from a record must stay as it is.
  const say = (words) => words[chinese() ? 1 : 0].replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
  const shown = new Map();

  // The library is in the file, compressed.
  const library = async () => {
    const packed = new Blob([bytes(text('plotting-library').trim())]);
    const source = await new Response(packed.stream().pipeThrough(new DecompressionStream('gzip'))).blob();
    const script = document.createElement('script');
    script.src = URL.createObjectURL(new Blob([source], {type: 'text/javascript'}));
    await new Promise((done, failed) => {
      script.onload = done;
      script.onerror = failed;
      document.head.append(script);
    });
  };

  const style = (box) => {
    const css = getComputedStyle(box.querySelector('svg.figure'));
    const read = (name) => css.getPropertyValue(name).trim();
    return {ink: read('--ink'), grid: read('--grid'), paper: read('--paper'),
            colours: [0, 1, 2, 3, 4, 5].map((k) => read('--c' + k))};
  };

  const trace = (series, look) => {
    const colour = look.colours[series.colour % look.colours.length];
    const made = {type: 'scatter', x: columns[series.x], y: columns[series.y], name: say(series.name),
                  showlegend: say(series.name) !== '', line: {color: colour, width: 1.7}, marker: {color: colour, size: series.few ? 7 : 4}};
    if (series.mark === 'points' || series.mark === 'squares') {
      made.mode = 'markers';
      made.marker.symbol = series.mark === 'squares' ? 'square' : 'circle';
    } else if (series.mark === 'steps') {
      made.mode = 'lines';
      made.line.shape = 'hv';
      const y = columns[series.y];
      made.x = [made.x[0], ...made.x];
      made.y = [0, ...y, 0];
    } else if (series.mark === 'band') {
      const x = columns[series.x];
      made.mode = 'lines';
      made.line.width = 0;
      made.fill = 'toself';
      made.fillcolor = colour;
      made.opacity = 0.3;
      made.hoverinfo = 'skip';
      made.x = [...x, ...[...x].reverse()];
      made.y = [...columns[series.y], ...[...columns[series.high]].reverse()];
    } else {
      made.mode = 'lines';
      if (series.mark === 'dashes') made.line.dash = 'dash';
    }
    if (series.whisker !== undefined) {
      made.error_y = {type: 'data', array: columns[series.whisker], color: colour, thickness: 1.4};
    }
    return made;
  };

  const axis = (about, look) => {
    const made = {title: {text: say(about.label)}, color: look.ink, gridcolor: look.grid, linecolor: look.ink,
                  zerolinecolor: look.grid, automargin: true, exponentformat: 'power', minexponent: 4};
    if (about.log) made.type = 'log';
    if (about.categories) {
      made.tickvals = about.categories.map((_, k) => k);
      made.ticktext = about.categories.map(say);
    }
    return made;
  };

  const guide = (line, look) => ({
    shape: {type: 'line', line: {color: look.ink, width: 1, dash: 'dot'},
            xref: line.vertical ? 'x' : 'paper', yref: line.vertical ? 'paper' : 'y',
            x0: line.vertical ? line.at : 0, x1: line.vertical ? line.at : 1,
            y0: line.vertical ? 0 : line.at, y1: line.vertical ? 1 : line.at},
    note: {text: say(line.label), showarrow: false, xref: line.vertical ? 'x' : 'paper',
           yref: line.vertical ? 'paper' : 'y', x: line.vertical ? line.at : 1, y: line.vertical ? 1 : line.at,
           xanchor: 'right', yanchor: 'bottom'},
  });

  const common = (figure, look) => ({
    title: {text: say(figure.title), font: {size: 14}, x: 0.5, y: 0.98, yanchor: 'top'},
    paper_bgcolor: look.paper, plot_bgcolor: look.paper, font: {color: look.ink, size: 12},
    margin: {l: 60, r: 12, t: (figure.series || []).some((s) => say(s.name)) ? 60 : 36, b: 44},
    legend: {orientation: 'h', x: 0, y: 1.02, yanchor: 'bottom'},
  });

  const flat = (figure, look) => {
    const guides = (figure.guides || []).map((line) => guide(line, look));
    return {
      traces: figure.series.map((series) => trace(series, look)),
      layout: Object.assign(common(figure, look), {
        xaxis: axis(figure.x, look), yaxis: axis(figure.y, look),
        shapes: guides.map((g) => g.shape), annotations: guides.map((g) => g.note).filter((n) => n.text),
      }),
    };
  };

  const space = (figure, look) => {
    const side = (k) => ({title: {text: say(figure.axes[k])}, color: look.ink, gridcolor: look.grid});
    const [x, y, z] = figure.space.map((k) => columns[k]);
    return {
      traces: [{type: 'scatter3d', mode: 'markers', x, y, z, marker: {size: 2.5, color: look.colours[0]}}],
      layout: Object.assign(common(figure, look), {
        margin: {l: 0, r: 0, t: 30, b: 0},
        scene: {xaxis: side(0), yaxis: side(1), zaxis: side(2), aspectmode: 'data',
                camera: {eye: {x: 1.6, y: 1.6, z: 1.0}, center: {x: 0, y: 0, z: -0.1}}},
      }),
    };
  };

  const hasSpace = () => {
    const canvas = document.createElement('canvas');
    return Boolean(canvas.getContext('webgl2') || canvas.getContext('webgl'));
  };

  const draw = async (figure) => {
    const box = document.getElementById('figure-' + figure.id);
    if (!box || (figure.space && !hasSpace())) return;
    const look = style(box);
    const made = figure.space ? space(figure, look) : flat(figure, look);
    const config = {responsive: true, displaylogo: false, showSendToCloud: false, locale: 'en',
                    toImageButtonOptions: {format: 'png', filename: figure.id, scale: 2}};
    box.classList.add('upgraded');
    try {
      await Plotly.react(box.querySelector('.live'), made.traces, made.layout, config);
      shown.set(figure.id, figure);
    } catch (error) {
      box.classList.remove('upgraded');  // the drawing stays
    }
  };

  const redraw = () => {
    document.documentElement.lang = chinese() ? 'zh-CN' : 'en';
    for (const figure of shown.values()) draw(figure);
  };

  const start = async () => {
    await library();
    const byBox = new Map(data.figures.map((figure) => [document.getElementById('figure-' + figure.id), figure]));
    const seen = new IntersectionObserver((entries) => {
      for (const entry of entries) {
        if (!entry.isIntersecting) continue;
        seen.unobserve(entry.target);
        draw(byBox.get(entry.target));
      }
    }, {rootMargin: '400px'});
    for (const box of byBox.keys()) if (box) seen.observe(box);
    for (const choice of document.querySelectorAll('input[name=language]')) choice.addEventListener('change', redraw);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', redraw);
    document.documentElement.dataset.interactive = 'yes';
  };
  if (typeof DecompressionStream === 'function') start().catch(() => {});
})();
