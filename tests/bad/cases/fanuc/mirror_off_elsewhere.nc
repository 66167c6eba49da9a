%
O0001
G51.1 X0.
G50.1 X5. Y0. Z0.
M30
%
(expect: 4:7 PS0010 IMPROPER G-CODE: `X5.` does not fit into `G50.1 X0. Y0. Z0.`)
(exit: 3)
