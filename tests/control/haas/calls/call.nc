%
O00001
(rule: Haas M98 P L: another program, variables are those of the caller)
(expect: #100=6)
(expect: to X3. Y0)
(expect: to X3. Y0)
(expect: to X3. Y3.)
#1=3
M98 P20 L2
G00 Y3.
M30
O00020
G00 X#1
#100=#100+#1
M99
%
