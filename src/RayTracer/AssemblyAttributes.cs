using System.Runtime.CompilerServices;

// Packets of lanes are large structs; clearing them before they are filled would cost more than much of the arithmetic.
[module: SkipLocalsInit]
