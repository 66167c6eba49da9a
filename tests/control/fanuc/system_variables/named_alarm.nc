%
O0001
(rule: F 6.6 [#_ALM] is #3000)
(expect: alarm MC3012 K5450 at 5:1)
[#_ALM]=12(NO)
M30
%
