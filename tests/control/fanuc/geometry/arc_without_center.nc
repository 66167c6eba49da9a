%
O0001
(rule: F 3.5 No.3403#5 CIR = 0: without centre and radius a line at feed)
(expect: warning K5213 at 7:1)
(expect: warning K5909 at 7:1)
(expect: to X10 Y5 line F100)
G02X10.Y5.F100
M30
%
