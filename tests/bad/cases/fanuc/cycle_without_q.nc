%
O0001
G00 X0. Y0. Z50.
G83 Z-10. R2. F100.
G80
M30
%
(expect: 4:1 PS0010 IMPROPER G-CODE: `G83` lacks words: `G83 Z{to} R{retract} Q{peck}`)
(exit: 3)
