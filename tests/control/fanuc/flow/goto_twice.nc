%
O0001
(rule: F 6.7 the first that is found, forward first; a target that stands twice is told once)
(expect: warning K5442 at 9:5)
(expect: #1=12)
#1=0
N10#1=#1+1
IF[#1GE12]GOTO20
GOTO10
N10#1=#1+10
GOTO10
N20M30
O0002
N20M99
%
