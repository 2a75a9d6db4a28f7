values = load('-ascii', 'values');
first = values(1);
constants = @BASE@_mex('preprocess', values(@INPUTS@ + 1:end));
values = values(1:@INPUTS@);
while true
  line = ''; % fgetl would wait for the character behind the line
  while true
    c = fread(stdin, 1);
    if isempty(c), exit; end
    if c == 10, break; end
    line(end + 1) = c;
  end
  calls = str2double(line);
  samples = repmat(values, 1, calls);
  samples(1, :) = first + 1e-7*mod(0:calls - 1, 16);
  begin = tic;
  output = @BASE@_mex('compute', samples, constants);
  printf('%.17g %.17g\n', toc(begin)*1e9/calls, sum(output(1, :)));
  fflush(stdout);
end
