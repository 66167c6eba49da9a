%
O0001
(rule: F 6.3 LE with vacant)
(expect: #10=1)
(expect: #11=1)
(expect: #12=1)
(expect: #13=1)
#10=0
#11=0
#12=0
#13=0
#2=0
IF[#1LE#0]THEN#10=1
IF[#1LE0]THEN#11=1
IF[#2LE#0]THEN#12=1
IF[#2LE0]THEN#13=1
M30
%
