%
O0001
(rule: F 6.8 No.6001#5: T calls O9000, #149 is its number)
(expect: #100=2)
T2
M30
O9000
#100=#149
T#149M06
M99
%
