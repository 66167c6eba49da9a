%
O0001
(rule: F 6.2 #200 and #900000: commons that are options, opened by a dialect file)
(expect: #200=5)
(expect: #900001=6)
#200=5
#900001=#200+1
M30
%
