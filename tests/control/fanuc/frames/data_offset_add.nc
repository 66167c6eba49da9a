%
O0001
(rule: F 3.4 G10 L2 under G91 adds to what the offset has)
(expect: to X12 Y20)
(expect: #1=11.5)
(expect: #2=20)
G91G10L2P2X1.5
G90G55G00X.5Y0.
#1=#5241
#2=#5242
M30
%
