# SPDX-License-Identifier: Apache-2.0
# Octave as a contestant, in matrix operations as its users write them: networks one by one, the textbook's
# Levenberg-Marquardt loop, dlmread. The contract is in contract/request.hpp.
1;

function asked = request()
  words = argv();
  asked = struct("task", words{1}, "seconds", 0.3, "epochs", 0, "data", "", "starts", "");
  for k = 2:2:numel(words)
    value = words{k + 1};
    name = words{k}(3:end);
    if any(strcmp(name, {"seconds", "epochs", "rows", "hidden"}))
      value = str2double(value);
    end
    asked.(name) = value;
  end
end

# Also returns the result of the last run of `work`.
function [seconds, repetitions, made] = measure(limit, work)
  times = [];
  begin = cputime();
  do
    start = cputime();
    made = work();
    times(end + 1) = cputime() - start;
    if numel(times) == 1 && times < limit
      begin = cputime();  # short work: the first run only warms up
    end
  until cputime() - begin >= limit
  if numel(times) > 1
    times(1) = [];
  end
  seconds = median(times);
  repetitions = numel(times);
end

function print_answer(seconds, repetitions, units, values, counts, weights)
  about = struct("version", version());
  result = struct("ns", 1e9 * seconds / units, "seconds", seconds, "repetitions", repetitions, ...
                  "peak_kib", 0, "values", {num2cell(values(:)')}, "counts", {num2cell(counts(:)')}, ...
                  "weights", {num2cell(weights, 2)'}, "about", about);
  printf("%s\n", jsonencode(result));
end

function [w, b, v, c] = parts(p)
  h = (numel(p) - 1) / 5;
  w = reshape(p(1:3 * h), 3, h);
  b = p(3 * h + 1:4 * h)';
  v = p(4 * h + 1:5 * h);
  c = p(end);
end

function [e, h] = residuals(p, x, t)
  [w, b, v, c] = parts(p);
  h = tanh(x * w + b);
  e = h * v + c - t;
end

function j = jacobian(p, x, h)
  [w, b, v, c] = parts(p);
  slope = (1 - h .^ 2) .* v';
  units = columns(h);
  j = [reshape(x, rows(x), 3, 1) .* reshape(slope, rows(x), 1, units)](:, :);
  j = [j, slope, h, ones(rows(x), 1)];
end

function [p, sse, epoch] = train_one(p, epochs, x, t)
  mu = 1e-3;
  epoch = 0;
  [e, h] = residuals(p, x, t);
  sse = e' * e;
  while epoch < epochs
    j = jacobian(p, x, h);
    normal = j' * j;
    gradient = j' * e;
    if norm(gradient) <= 1e-7
      return
    end
    found = false;
    while ! found && mu <= 1e10
      trial = p - (normal + mu * eye(numel(p))) \ gradient;
      [trial_e, trial_h] = residuals(trial, x, t);
      trial_sse = trial_e' * trial_e;
      found = trial_sse < sse;
      if ! found
        mu *= 10;
      end
    end
    if ! found
      return
    end
    p = trial;
    e = trial_e;
    h = trial_h;
    sse = trial_sse;
    mu = max(0.1 * mu, 1e-20);
    epoch += 1;
  end
end

function rmse = forward(swarm, x, t)
  rmse = zeros(1, columns(swarm));
  for k = 1:columns(swarm)
    e = residuals(swarm(:, k), x, t);
    rmse(k) = sqrt(e' * e / numel(t));
  end
end

function runs = train(starts, epochs, x, t)
  runs = struct("weights", zeros(size(starts)), "rmse", [], "epochs", []);
  for k = 1:columns(starts)
    [p, sse, epoch] = train_one(starts(:, k), epochs, x, t);
    runs.weights(:, k) = p;
    runs.rmse(k) = sqrt(sse / numel(t));
    runs.epochs(k) = epoch;
  end
end

function lines = header_lines(path)
  file = fopen(path);
  lines = 1;
  while strncmp(fgetl(file), "#", 1)
    lines += 1;
  end
  fclose(file);
end

asked = request();
if strcmp(asked.task, "read")
  [seconds, n, table] = measure(asked.seconds, @() dlmread(asked.data, ",", header_lines(asked.data), 0));
  print_answer(seconds, n, stat(asked.data).size, [rows(table), mean(table(:, 4) .^ 2)], [], []);
else
  data = dlmread(asked.data, ",");
  x = data(:, 1:3);
  t = data(:, 4);
  networks = dlmread(asked.starts, ",")';
  if strcmp(asked.task, "forward")
    [seconds, n, rmse] = measure(asked.seconds, @() forward(networks, x, t));
    print_answer(seconds, n, numel(t) * columns(networks), rmse, [], []);
  else
    [seconds, n, runs] = measure(asked.seconds, @() train(networks, asked.epochs, x, t));
    print_answer(seconds, n, numel(t) * sum(runs.epochs), runs.rmse, runs.epochs, runs.weights');
  end
end
