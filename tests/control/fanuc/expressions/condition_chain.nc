%
O0001
(rule: F 6.4 what is compared is no comparison: AND binds stronger than EQ, and the brackets are missing)
(expect: alarm PS0114 K5401 at 6:14)
#1=3
IF[#3EQ1AND#1EQ3]GOTO9
#4=1
N9M30
%
