using System.Buffers.Binary;
using System.Text;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>Writes portable float maps (Debevec's PFM): 32-bit floats, rows from bottom to top.</summary>
internal static class PfmWriter
{
    /// <summary>Writes an image as it is, bit for bit; its rows are read from the last to the first.</summary>
    /// <param name="output">The destination.</param>
    /// <param name="image">Linear RGB.</param>
    /// <param name="grey">True to write luminance alone (Pf) instead of colour (PF).</param>
    /// <param name="bigEndian">Byte order; most readers know both.</param>
    public static void Write(Stream output, IImageRows image, bool grey = false, bool bigEndian = false)
    {
        string header = $"{(grey ? "Pf" : "PF")}\n{image.Width} {image.Height}\n{(bigEndian ? "1.0" : "-1.0")}\n";
        output.Write(Encoding.ASCII.GetBytes(header));
        var row = new float[3 * image.Width];
        int channels = grey ? image.Width : row.Length;
        var bytes = new byte[4 * channels];
        for (int y = image.Height - 1; y >= 0; y--)
        {
            image.ReadRow(y, row);
            for (int i = 0; i < channels; i++)
            {
                float value = grey ? new Rgb(row[3 * i], row[(3 * i) + 1], row[(3 * i) + 2]).Luminance : row[i];
                if (bigEndian)
                {
                    BinaryPrimitives.WriteSingleBigEndian(bytes.AsSpan(4 * i), value);
                }
                else
                {
                    BinaryPrimitives.WriteSingleLittleEndian(bytes.AsSpan(4 * i), value);
                }
            }

            output.Write(bytes);
        }
    }
}
