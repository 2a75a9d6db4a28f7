kernel = @BASE@();
values = load('-ascii', 'values');
first = values(1);
constants = kernel.preprocess(values(@INPUTS@ + 1:end));
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
  total = 0;
  begin = tic;
  for i = 0:calls - 1
    values(1) = first + 1e-7*mod(i, 16);
    output = kernel.compute(values, constants);
    total = total + output(1);
  end
  printf('%.17g %.17g\n', toc(begin)*1e9/calls, total);
  fflush(stdout);
end
