%
O0001
(rule: F 3.1 lathe: where X and U stand in one block, the later one counts)
(expect: to X20 Z5)
(expect: to X18 Z5)
G00 X40. Z5.
X50. U-4.
M30
%
