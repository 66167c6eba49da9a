%
O0001
(rule: F 6.5 #100=#5061 is an assignment, though Kadr writes the line for a phrase of its own: the middle of two touches)
(expect: #100=-50)
(expect: #101=50)
(expect: path X10 X0 X1)
G90G94G54
G00X10.
G31X-50.F100
#100=#5061
G00X0
G31X50.F100
#101=#5061
G00X[[#100+#101]/2+1.]
M30
%
