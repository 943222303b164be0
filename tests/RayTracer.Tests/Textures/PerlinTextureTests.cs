using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Tests.Textures;

/// <summary>Covers `PerlinTexture`, `DotsTexture`.</summary>
public class PerlinTextureTests
{
    [Fact]
    public void Octaves_are_summed_as_they_are()
    {
        (float x, float y, float z) = (0.3f, -1.7f, 2.2f);
        float[] octaves = [.. Enumerable.Range(0, 3).Select(i => Noise(x * MathF.Pow(1.99f, i), y * MathF.Pow(1.99f, i), z * MathF.Pow(1.99f, i)))];
        float Sum(Func<float, float> of) => of(octaves[0]) + (0.7f * of(octaves[1])) + (0.49f * of(octaves[2]));
        Assert.Equal(Sum(n => n), Value(new() { Octaves = 3, Roughness = 0.7f }, x, y, z), 2e-5f);
        Assert.Equal(Sum(MathF.Abs), Value(new() { Octaves = 3, Roughness = 0.7f, Pattern = PerlinPattern.Wrinkled }, x, y, z), 2e-5f);
    }

    [Fact]
    public void Waves_are_high_where_the_wind_blows()
    {
        (float x, float y, float z) = (3.3f, -1.7f, 2.2f);
        float wind = Value(new() { Octaves = 3 }, 0.1f * x, 0.1f * y, 0.1f * z);
        float waves = Value(new() { Octaves = 6 }, x, y, z);
        Assert.Equal(MathF.Abs(wind) * waves, Value(new() { Pattern = PerlinPattern.Windy }, x, y, z), 1e-6f);
    }

    // Where the noise does not bend it, a sine of y goes along six pieces, each from its own first corner to its last: the fourth begins in the middle.
    [Theory]
    [InlineData(0, 0.5f, 0.5f)]
    [InlineData(Math.PI / 2, 0.58f, 0.6f)]
    [InlineData(-Math.PI / 2, 0.58f, 0.6f)]
    public void Marble_goes_along_a_curve_of_colours(double y, float red, float blue)
    {
        Color(new() { Pattern = PerlinPattern.Marble, Variation = 0 }, 0.4f, (float)y, 0.1f, out RgbW color);
        Assert.Equal(1.5f * red, color.R[0], 1e-4f);
        Assert.Equal(1.5f * blue, color.B[0], 1e-4f);
    }

    [Fact]
    public void Dots_have_their_size_and_stand_where_noise_is_positive()
    {
        DotsTexture dots = (DotsTexture)new DotsTextureDescription { Scale = new(10, 10) }.Build(new SceneBuilder());
        int inside = 0;
        for (int column = 0; column < 10; column++)
        {
            int inField = 0;
            for (int i = 0; i < 40 * 40; i++)
            {
                float u = (column - 0.5f + (((i % 40) + 0.5f) / 40)) / 10;
                float v = (3 - 0.5f + (((i / 40) + 0.5f) / 40)) / 10;
                dots.Evaluate(u, v, out RgbW color);
                inField += color.R[0] > 0 ? 1 : 0;
            }

            // π · 0.35² of the field, where there is a dot.
            Assert.Equal(Noise(column + 0.5f, 3.5f, 0.5f) > 0 ? Math.PI * 0.35 * 0.35 : 0, inField / 1600.0, 0.02);
            inside += inField;
        }

        Assert.True(inside > 0);
    }

    private static float Noise(float x, float y, float z) => GradientNoise.Tabled(new Vec3W(x, y, z))[0];

    private static float Value(PerlinTextureDescription what, float x, float y, float z)
    {
        Color(what, x, y, z, out RgbW color);
        return color.R[0];
    }

    private static void Color(PerlinTextureDescription what, float x, float y, float z, out RgbW color) =>
        what.Build(new SceneBuilder()).Evaluate(new TexturePointW { U = 0f, V = 0f, Local = new(x, y, z), World = new(x, y, z) }, out color);
}
