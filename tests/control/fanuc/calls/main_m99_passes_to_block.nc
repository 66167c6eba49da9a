%
O0001
(rule: F 6.8 M99 P begins at that block again; blocks with numbers behind it make it no loop of its own where passes are counted)
(passes: 2)
(expect: #500=1)
(expect: #501=2)
#500=#500+1
N10#501=#501+1
M99P10
N20M30
%
