using System.Globalization;
using System.Text;

namespace RayTracer.Import.Tests;

/// <summary>Writes PLY files number by number.</summary>
internal sealed class TestPly(string format)
{
    private readonly List<byte> _bytes = [];

    public TestPly Header(params string[] lines)
    {
        foreach (string line in (string[])["ply", $"format {format} 1.0", .. lines, "end_header"])
        {
            _bytes.AddRange(Encoding.ASCII.GetBytes(line + "\n"));
        }

        return this;
    }

    public TestPly Add(string type, params double[] values)
    {
        foreach (double value in values)
        {
            _bytes.AddRange(format == "ascii" ? Encoding.ASCII.GetBytes(value.ToString("R", CultureInfo.InvariantCulture) + (_bytes.Count % 3 == 0 ? "\n" : " ")) : Binary(type, value));
        }

        return this;
    }

    public byte[] Bytes() => [.. _bytes];

    private byte[] Binary(string type, double value)
    {
        byte[] bytes = type switch
        {
            "char" or "int8" => [(byte)(sbyte)value],
            "uchar" or "uint8" => [(byte)value],
            "short" or "int16" => BitConverter.GetBytes((short)value),
            "ushort" or "uint16" => BitConverter.GetBytes((ushort)value),
            "int" or "int32" => BitConverter.GetBytes((int)value),
            "uint" or "uint32" => BitConverter.GetBytes((uint)value),
            "float" or "float32" => BitConverter.GetBytes((float)value),
            _ => BitConverter.GetBytes(value),
        };
        if (format == "binary_big_endian" == BitConverter.IsLittleEndian)
        {
            Array.Reverse(bytes);
        }

        return bytes;
    }
}
