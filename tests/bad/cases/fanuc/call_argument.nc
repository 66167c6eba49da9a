%
O0001
G65 P9100 N5
M30
%
(expect: 3:11 PS0129 USE 'G' AS ARGUMENT: `N` cannot be an argument)
(exit: 3)
