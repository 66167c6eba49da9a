%
O0001
(rule: F 1.3 No.3404#7 M3B = 1: three M codes a block)
S500M03M08M19
M30
%
