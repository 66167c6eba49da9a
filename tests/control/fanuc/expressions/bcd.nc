%
O0001
(rule: F 6.4 BIN and BCD)
(expect: #1=291)
(expect: #2=123)
#1=BCD[123]
#2=BIN[291]
M30
%
