%
O0001
(rule: F 6.5 n is 0 to 200)
(expect: alarm  K5451 at 5:1)
#3000=201(X)
M30
%
