%
O0202(G71 TYPE II WITH POCKETS)
(rule: F 5.6 G71 with both axes in the first block: pockets are roughed one by one)
(expect: path X52Z3 X52.6 X48.6 z-43f0.3 x49.2 Z3 X44.6 z-43 x45.2 Z3 X40.6 z-43 x41.2 Z3 X36.6 z-42.583 x37.2 Z3 X32.6)
(expect: path z-27.333 x33.2 Z3 X28.6 z-9 x29.2 Z3 X24.6 z-7 x25.2 X33.2 Z-12 x28.6 z-24.667 x29.2 X37.2 Z-35.333 x32.6)
(expect: path z-41 x33.2 X52.6 Z3 X20.6 z-5 x30.6z-10 x24.6z-16 z-22 x36.6z-30 x30.6z-38 cw:x40.6z-43 x52.6 X52Z3 X20)
(expect: path z-5f0.15 x30z-10 x24z-16 z-22 x36z-30 x30z-38 cw:x40z-43 x52 Z3 X100Z100)
T0101
G96S150M3
G0X52.Z3.
G71U2.R0.3
G71P1Q2U0.6W0F0.3
N1G0X20.Z3.
G1Z-5.F0.15
X30.Z-10.
X24.Z-16.
Z-22.
X36.Z-30.
X30.Z-38.
G2X40.Z-43.R5.
N2G1X52.
G70P1Q2
G0X100.Z100.
M30
%
