%
O0001
(rule: F 6.3 GT with vacant)
(expect: #10=0)
(expect: #11=0)
(expect: #12=0)
(expect: #13=0)
#10=0
#11=0
#12=0
#13=0
#2=0
IF[#1GT#0]THEN#10=1
IF[#1GT0]THEN#11=1
IF[#2GT#0]THEN#12=1
IF[#2GT0]THEN#13=1
M30
%
