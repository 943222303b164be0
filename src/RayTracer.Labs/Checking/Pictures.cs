using RayTracer.Imaging;
using RayTracer.Textbook;
using RayTracer.Textures;

namespace RayTracer.Labs;

/// <summary>Makes pictures to look at.</summary>
public static class Pictures
{
    private const int Gap = 4;

    /// <summary>A picture, its reference, and how much they differ.</summary>
    /// <param name="title">What they are.</param>
    /// <param name="width">Width of each in pixels.</param>
    /// <param name="height">Height in pixels.</param>
    /// <param name="found">The picture, row by row.</param>
    /// <param name="expected">The reference.</param>
    public static Exhibit Beside(string title, int width, int height, IReadOnlyList<Rgb> found, IReadOnlyList<Rgb> expected)
    {
        Picture all = new((3 * width) + (2 * Gap), height);
        Array.Fill(all.Pixels, 1);
        for (int i = 0; i < width * height; i++)
        {
            Rgb difference = found[i] - expected[i];
            Rgb[] panels = [found[i], expected[i], new(Math.Abs(difference.R), Math.Abs(difference.G), Math.Abs(difference.B))];
            for (int panel = 0; panel < panels.Length; panel++)
            {
                int at = 3 * ((i / width * all.Width) + (panel * (width + Gap)) + (i % width));
                (all.Pixels[at], all.Pixels[at + 1], all.Pixels[at + 2]) = ((float)panels[panel].R, (float)panels[panel].G, (float)panels[panel].B);
            }
        }

        return new(title, "png", ImageFile.Encode(".png", all, new()));
    }
}
