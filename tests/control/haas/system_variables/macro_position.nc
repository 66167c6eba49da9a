%
O00001
(rule: Haas #5001 and on: the end of the last block; #5041 the work position)
(expect: #100=10)
(expect: #101=5)
(expect: to X10 Y5)
G00 X10. Y5.
#100=#5001
#101=#5042
M30
%
