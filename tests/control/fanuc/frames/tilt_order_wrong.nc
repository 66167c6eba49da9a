%
O0001
(rule: F 4.8 PS5457: the blocks of P2 in another order)
(expect: alarm PS5457 K5652 at 6:1)
G68.2P2Q1X0Y0Z0
G68.2P2Q3X1.Y0Z0
M30
%
