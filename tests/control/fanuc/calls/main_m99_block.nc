%
O0001
(rule: F 6.4 M99 P in the main program: forward it is a jump, back it begins again)
(expect: warning K5900 at 12:1)
(expect: #500=1)
(expect: #501 vacant)
(expect: #502=1)
N10#500=#500+1
M99P20
#501=1
N20#502=1
M99P10
M30
%
