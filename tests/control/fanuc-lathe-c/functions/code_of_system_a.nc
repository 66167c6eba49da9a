%
O0001
(rule: F 2.4 G21 in system C is the cycle of a thread and no unit: its alarm says so)
(machine: lathe)
(expect: alarm PS0011 K5244 at 7:1)
(expect: fix in G-code system C `G21` is the cycle that cuts a thread, and `G71` says millimetres; in system A and B it is that: `-d fanuc-lathe`, `-d fanuc-lathe-b`)
G21G90G40G95
M30
%
