using System.Numerics;
using System.Runtime.InteropServices;

namespace RayTracer.Imaging;

/// <summary>
/// The cyclic redundancy check with Castagnoli's polynomial (Castagnoli, Bräuer &amp; Herrmann 1993; RFC 3720, section 12.1), for which
/// processors have an instruction.
/// </summary>
internal static class Crc32C
{
    /// <summary>The check of bytes that follow others.</summary>
    /// <param name="check">That of the others; 0 where there are none.</param>
    /// <param name="bytes">The bytes that follow.</param>
    public static uint Append(uint check, ReadOnlySpan<byte> bytes)
    {
        uint rest = ~check;
        ReadOnlySpan<ulong> words = MemoryMarshal.Cast<byte, ulong>(bytes);
        foreach (ulong word in words)
        {
            rest = BitOperations.Crc32C(rest, word);
        }

        foreach (byte last in bytes[(words.Length * sizeof(ulong))..])
        {
            rest = BitOperations.Crc32C(rest, last);
        }

        return ~rest;
    }
}
