%
O00001
(rule: Haas lathe: words of cycles in the blocks that repeat them: the start of a thread, the dwell, L)
(machine: lathe)
T0101
G97 S500 M03
G00 X22. Z5.
G92 X19. Z-10. F1.5
X18.5 Q180000
G00 X0. Z5.
G82 Z-3. R2. P0.5 F0.1
Z-4. P0.7 L1
G80
M30
%
