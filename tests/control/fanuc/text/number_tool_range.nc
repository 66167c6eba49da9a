%
O0001
(rule: F 1.6 T and M have up to eight digits, H and D three)
T12345678
M30
%
