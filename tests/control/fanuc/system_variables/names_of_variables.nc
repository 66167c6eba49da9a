%
O0001
(rule: F 6.6 SETVN names #500 and those behind it; the names stand between brackets, on the left as well)
(expect: #500=12)
(expect: #501=6)
(expect: #1=18)
(expect: path X12Z6)
SETVN 500[PROBEX,PROBEZ]
[#PROBEX]=12
[#PROBEZ]=[#PROBEX]/2
#1=[[#PROBEX]+[#PROBEZ]]
M98P2000
M30
O2000
G00X[#PROBEX]Z[#PROBEZ]
M99
%
