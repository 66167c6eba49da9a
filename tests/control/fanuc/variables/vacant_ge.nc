%
O0001
(rule: F 6.3 GE with vacant)
(expect: #10=1)
(expect: #11=1)
(expect: #12=1)
(expect: #13=1)
#10=0
#11=0
#12=0
#13=0
#2=0
IF[#1GE#0]THEN#10=1
IF[#1GE0]THEN#11=1
IF[#2GE#0]THEN#12=1
IF[#2GE0]THEN#13=1
M30
%
