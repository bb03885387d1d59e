// SPDX-License-Identifier: Apache-2.0
// Opens reports in a real browser, as their readers do: from disk, in both languages, with and without JavaScript and
// WebGL, on wide and narrow screens, and on paper.
//   node reports.mjs FOLDER     the reports, and where pictures, PDFs and ctest.xml go
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import {chromium} from 'playwright-core';

const folder = path.resolve(process.argv[2]);
const axe = fs.readFileSync(new URL('./node_modules/axe-core/axe.min.js', import.meta.url), 'utf8');
const kinds = JSON.parse(fs.readFileSync(path.join(folder, 'kinds.json'), 'utf8'));
const browsers = {};
const software = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
const launch = (webgl) => chromium.launch({executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
                                           args: ['--no-sandbox', ...(webgl ? software : ['--disable-gpu', '--disable-3d-apis'])]});

const failures = [];
let checks = 0;
const check = (truth, what) => {
  ++checks;
  if (!truth) failures.push(what);
};
const equal = (found, expected, what) => check(JSON.stringify(found) === JSON.stringify(expected),
                                               `${what}: found ${JSON.stringify(found)}, expected ${JSON.stringify(expected)}`);

// Opens a report and collects what it complains of and what it asks for.
const open = async (kind, {width = 1280, language = 'en', javascript = true, webgl = true, scheme = 'light'}) => {
  browsers[webgl] ??= await launch(webgl);
  const context = await browsers[webgl].newContext({viewport: {width, height: 900}, javaScriptEnabled: javascript,
                                                    colorScheme: scheme, acceptDownloads: true});
  const page = await context.newPage();
  const complaints = [];
  page.on('console', (message) => { if (message.type() === 'error') complaints.push(message.text()); });
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('request', (request) => { if (!/^(file|blob|data):/.test(request.url())) complaints.push('request ' + request.url()); });
  await page.goto('file://' + path.join(folder, kind + '.html'));
  if (language === 'zh') await page.click('label[for=lang-zh]');
  return {page, complaints, close: () => context.close()};
};

// Figures are made when they come into view. Those in space stay drawings without WebGL.
const upgraded = async (page, webgl = true) => {
  await page.waitForFunction(() => document.documentElement.dataset.interactive === 'yes', null, {timeout: 20000});
  const figures = await page.evaluate(() => JSON.parse(document.getElementById('figure-data').textContent).figures
      .map((figure) => ({id: figure.id, space: Boolean(figure.space)})));
  for (const {id, space} of figures) {
    await page.evaluate((place) => document.getElementById(place).scrollIntoView(), 'figure-' + id);
    if (space && !webgl) continue;
    await page.waitForSelector(`#figure-${id}.upgraded .live > *`, {timeout: 20000});
  }
  await page.evaluate(() => scrollTo(0, 0));
};

// Texts of drawings that leave the drawing or lie on one another; columns that leave the page.
const layout = (page) => page.evaluate(() => {
  const wrong = [];
  const shown = (element) => element.checkVisibility?.({visibilityProperty: true}) ?? element.getClientRects().length > 0;
  const width = document.documentElement.clientWidth;
  if (document.documentElement.scrollWidth > width) wrong.push(`the page is ${document.documentElement.scrollWidth} wide of ${width}`);
  for (const svg of document.querySelectorAll('svg.figure:not(.bar)')) {
    if (!shown(svg)) continue;
    const frame = svg.getBoundingClientRect();
    const texts = [...svg.querySelectorAll('text')].filter((t) => t.textContent && t.getClientRects().length);
    const boxes = texts.map((t) => t.getBoundingClientRect());
    const figure = svg.closest('figure')?.id;
    boxes.forEach((a, k) => {
      if (a.left < frame.left - 1 || a.right > frame.right + 1 || a.top < frame.top - 1 || a.bottom > frame.bottom + 1)
        wrong.push(`${figure}: '${texts[k].textContent}' is cut`);
      for (let m = k + 1; m < boxes.length; ++m) {
        const b = boxes[m];
        const across = Math.min(a.right, b.right) - Math.max(a.left, b.left);
        const down = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
        if (across > 1.5 && down > 0.35 * Math.min(a.height, b.height))
          wrong.push(`${figure}: '${texts[k].textContent}' lies on '${texts[m].textContent}'`);
      }
    });
  }
  for (const element of document.querySelectorAll('h1, h2, h3, p, dt, dd, .finding')) {
    if (shown(element) && element.getBoundingClientRect().right > width + 1) wrong.push(`cut: ${element.textContent.slice(0, 40)}`);
  }
  return wrong;
});

const drawn = (page) => page.evaluate(() => [...document.querySelectorAll('figure')].map((f) => {
  const svg = f.querySelector('svg.figure');
  return Boolean(svg && svg.getBoundingClientRect().height > 50 && svg.querySelectorAll('path').length);
}));

const visibleWords = (page) => page.evaluate(() => {
  const walker = document.createTreeWalker(document.querySelector('main'), NodeFilter.SHOW_TEXT);
  let text = '';
  while (walker.nextNode()) {
    const parent = walker.currentNode.parentElement;
    if (parent.closest('script, style, .live') || !parent.getClientRects().length) continue;
    text += ' ' + walker.currentNode.textContent;
  }
  return text;
});

const tests = [];
const test = (name, body) => tests.push({name, body});

// Every kind is opened in both languages and at both widths as it is without JavaScript; the rest varies with them.
for (const {kind, live, space, title} of kinds) {
  for (const language of ['en', 'zh']) {
    for (const width of [1280, 390]) {
      test(`${kind} ${language} ${width}: complete without JavaScript`, async () => {
        const {page, complaints, close} = await open(kind, {width, language, javascript: false});
        equal(complaints, [], 'complaints');
        const figures = await drawn(page);
        check(figures.length > 0 && figures.every(Boolean), `drawings that are missing: ${figures}`);
        equal(await layout(page), [], 'layout');
        check((await page.textContent('h1')).includes(title[language]), 'heading');
        await page.screenshot({path: path.join(folder, `${kind}-${language}-${width}-still.png`), fullPage: true});
        await close();
      });
    }
  }
  for (const [language, width] of [['en', 1280], ['zh', 390]]) {
    test(`${kind} ${language} ${width}: figures that can be zoomed`, async () => {
      const {page, complaints, close} = await open(kind, {width, language});
      await upgraded(page);
      equal(await page.locator('figure.upgraded').count(), live, 'figures with plotly.js');
      equal(complaints, [], 'complaints');
      equal(await layout(page), [], 'layout');
      const covered = await page.evaluate(() => [...document.querySelectorAll('figure.upgraded')].filter((figure) => {
        const legend = figure.querySelector('.legend')?.getBoundingClientRect();
        const plot = figure.querySelector('.nsewdrag')?.getBoundingClientRect();
        return legend && plot && legend.bottom > plot.top + 2;
      }).map((figure) => figure.id));
      equal(covered, [], 'legends that cover data');
      await page.screenshot({path: path.join(folder, `${kind}-${language}-${width}.png`), fullPage: true});
      await close();
    });
  }
  for (const [language, scheme] of [['en', 'light'], ['zh', 'dark']]) {
    test(`${kind} ${language} ${scheme}: accessible`, async () => {
      const {page, close} = await open(kind, {language, scheme});
      await page.evaluate(axe);
      const found = await page.evaluate(() => axe.run(document, {resultTypes: ['violations']}));
      const serious = found.violations.filter((v) => v.impact === 'serious' || v.impact === 'critical')
          .map((v) => `${v.id}: ${v.nodes.slice(0, 3).map((n) => n.target).join(' ')}`);
      equal(serious, [], 'axe');
      const levels = await page.evaluate(() => [...document.querySelectorAll('h1, h2, h3')].map((h) => Number(h.tagName[1])));
      check(levels[0] === 1 && levels.every((level, k) => k === 0 || level - levels[k - 1] <= 1), 'order of the headings');
      await close();
    });
  }
  for (const language of ['en', 'zh']) {
    test(`${kind} ${language}: prints`, async () => {
      const {page, close} = await open(kind, {language, javascript: false});
      const file = path.join(folder, `${kind}-${language}.pdf`);
      await page.pdf({path: file, format: 'A4', preferCSSPageSize: true});
      const text = execFileSync('pdftotext', ['-layout', file, '-'], {encoding: 'utf8'});
      const pages = text.split('\f').length - 1;
      check(pages >= 2 && pages < 30, `pages: ${pages}`);
      check(text.replaceAll(/\s/g, '').includes(title[language].replaceAll(/\s/g, '')), 'the title on paper');
      await close();
    });
  }
  test(`${kind}: one language at a time`, async () => {
    const {page, close} = await open(kind, {});
    const english = await visibleWords(page);
    check(!/[\u4e00-\u9fff]/.test(english.replaceAll(/The paper: [^.]*\./g, '')), 'Chinese words in the English page');
    await page.click('label[for=lang-zh]');
    check(/[\u4e00-\u9fff]/.test(await page.textContent('h1 [lang=zh]')), 'Chinese heading');
    equal(await page.evaluate(() => document.querySelectorAll('main [lang=en]').length > 0 &&
      [...document.querySelectorAll('main [lang=en]')].every((e) => !e.getClientRects().length)), true, 'English is hidden');
    await close();
  });
  test(`${kind}: switches the language of figures, hides a series, saves an image`, async () => {
    const {page, complaints, close} = await open(kind, {});
    await upgraded(page);
    const figure = page.locator('figure.upgraded:has(.gtitle)').first();
    await page.click('label[for=lang-zh]');
    await page.waitForFunction((id) => /[\u4e00-\u9fff]/.test(document.getElementById(id).querySelector('.gtitle').textContent),
                               await figure.getAttribute('id'));
    await figure.scrollIntoViewIfNeeded();
    const legend = page.locator('figure.upgraded .legendtoggle').first();
    if (await legend.count()) {
      await legend.scrollIntoViewIfNeeded();
      await legend.click();
      await page.waitForFunction(() => document.querySelector('.legend .traces[style*="opacity: 0.5"]'));
    }
    await figure.hover();
    const [download] = await Promise.all([page.waitForEvent('download'), figure.locator('.modebar-btn').first().click()]);
    equal(fs.readFileSync(await download.path()).subarray(1, 4).toString(), 'PNG', 'the saved image');
    equal(complaints, [], 'complaints');
    await close();
  });
  if (space) {
    test(`${kind}: keeps the drawing in space without WebGL`, async () => {
      const {page, complaints, close} = await open(kind, {webgl: false});
      await upgraded(page, false);
      equal(await page.locator('figure.upgraded').count(), live - space, 'figures with plotly.js');
      check((await drawn(page)).filter(Boolean).length >= space, 'drawings');
      equal(complaints, [], 'complaints');
      await close();
    });
  }
}

const escaped = (text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');
const cases = [];
for (const {name, body} of tests) {
  failures.length = 0;
  try {
    await body();
  } catch (error) {
    failures.push(String(error.message ?? error).split('\n').slice(0, 4).join(' '));
  }
  if (failures.length) console.log(`FAILED: ${name}\n  ${failures.join('\n  ')}`);
  cases.push(`<testcase name="${escaped(name)}">${failures.length ? `<failure message="${escaped(failures[0])}"/>` : ''}</testcase>`);
}
for (const browser of Object.values(browsers)) await browser.close();
const failed = cases.filter((c) => c.includes('<failure')).length;
fs.writeFileSync(path.join(folder, 'ctest.xml'),
                 `<testsuite name="browser" tests="${cases.length}" failures="${failed}" skipped="0">\n${cases.join('\n')}\n</testsuite>\n`);
console.log(`${cases.length - failed} of ${cases.length} tests of reports in a browser passed (${checks} checks)`);
process.exit(failed ? 1 : 0);
