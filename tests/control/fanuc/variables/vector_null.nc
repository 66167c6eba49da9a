%
O0001
(rule: F 12 #2=#0, #3=#2+0, X#0Y5., X[#0+0]Y5.)
(expect: #2 vacant)
(expect: #3=0)
(expect: to X7)
(expect: to X7 Y5)
(expect: to X0 Y6)
#2=#0
#3=#2+0
G00X7.
X#0Y5.
X[#0+0]Y6.
M30
%
