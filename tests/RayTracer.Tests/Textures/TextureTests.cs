using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Tests.Textures;

public class TextureTests
{
    // Rows from the top: red = 1, 2 / 3, 4.
    private static readonly Picture s_four = new(2, 2, [1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0]);

    [Theory]
    [InlineData(0.25f, 0.75f, 1)]
    [InlineData(0.75f, 0.75f, 2)]
    [InlineData(0.25f, 0.25f, 3)]
    [InlineData(0.75f, 0.25f, 4)]
    public void All_interpolations_go_through_the_texels_and_the_picture_stands_upright(float u, float v, float expected)
    {
        foreach (Interpolation interpolation in Enum.GetValues<Interpolation>())
        {
            Assert.Equal(expected, Red(Texture(interpolation, Wrapping.Repeat), u, v), 5);
        }
    }

    [Theory]
    [InlineData(Interpolation.Nearest, 0.49f, 1)]
    [InlineData(Interpolation.Nearest, 0.51f, 2)]
    [InlineData(Interpolation.Bilinear, 0.5f, 1.5)]
    [InlineData(Interpolation.Bilinear, 0.375f, 1.25)]
    public void Between_texels_each_interpolates_its_way(Interpolation interpolation, float u, double expected) =>
        Assert.Equal(expected, Red(Texture(interpolation, Wrapping.Clamp), u, 0.75f), 5);

    [Fact]
    public void Bicubic_is_the_Catmull_Rom_spline_of_its_neighbours()
    {
        // On a ramp of clamped texels 0 0 1 1 … at the middle, symmetry gives one half; at a quarter, the spline's own value.
        Picture step = new(4, 1, [0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0]);
        ImageTexture texture = new(step, Interpolation.Bicubic, Wrapping.Clamp, Vector2.One, Vector2.Zero);
        Assert.Equal(0.5, Red(texture, 0.5f, 0.5f), 5);
        Assert.Equal(0.203125, Red(texture, 1.75f / 4, 0.5f), 5);
    }

    [Fact]
    public void A_picture_has_the_luminance_of_coloured_pixels_and_the_bits_of_grey_ones()
    {
        Picture grey = new Picture(2, 1, [0.5f, 0.25f, 1, 0.3f, 0.3f, 0.3f]).Grey();
        Assert.Equal((0.2126 * 0.5) + (0.7152 * 0.25) + 0.0722, grey.Pixels[0], 1e-6);
        Assert.Equal(grey.Pixels[0], grey.Pixels[2]);
        Assert.All(grey.Pixels[3..], p => Assert.Equal(0.3f, p));
    }

    [Fact]
    public void Bicubic_never_undershoots_below_black()
    {
        ImageTexture texture = new(new(4, 1, [0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0]), Interpolation.Bicubic, Wrapping.Clamp, Vector2.One, Vector2.Zero);
        for (int i = 0; i <= 100; i++)
        {
            Assert.True(Red(texture, i / 100f, 0.5f) >= 0);
        }
    }

    [Theory]
    [InlineData(Wrapping.Repeat, 1.25f, 1)]
    [InlineData(Wrapping.Repeat, -0.25f, 2)]
    [InlineData(Wrapping.Clamp, 1.25f, 2)]
    [InlineData(Wrapping.Clamp, -7.3f, 1)]
    [InlineData(Wrapping.Mirror, 1.25f, 2)]
    [InlineData(Wrapping.Mirror, 1.75f, 1)]
    [InlineData(Wrapping.Mirror, -0.25f, 1)]
    public void Wrapping_says_what_lies_outside(Wrapping wrapping, float u, double expected) =>
        Assert.Equal(expected, Red(Texture(Interpolation.Nearest, wrapping), u, 0.75f), 5);

    [Fact]
    public void Above_and_below_the_picture_another_wrapping_may_hold()
    {
        ImageTexture texture = new(s_four, Interpolation.Nearest, Wrapping.Repeat, Vector2.One, Vector2.Zero, Wrapping.Clamp);
        Assert.Equal(1, Red(texture, 1.25f, 1.25f));
        Assert.Equal(3, Red(texture, 1.25f, -0.25f));
    }

    [Fact]
    public void A_product_multiplies_channel_by_channel_and_is_constant_where_both_factors_are()
    {
        Texture half = new SolidTexture(new(0.5f, 1, 2));
        Assert.Equal(1.5f, Red(new ProductTexture(Texture(Interpolation.Nearest, Wrapping.Repeat), half), 0.25f, 0.25f));
        Assert.Equal(new Rgb(0.25f, 1, 4), new ProductTexture(half, half).Constant);
        Assert.Null(new ProductTexture(Texture(Interpolation.Nearest, Wrapping.Repeat), half).Constant);
    }

    [Theory]
    [InlineData(0, 0.25f, 0.25f, 3)]
    [InlineData(90, 0.25f, 0.25f, 4)]
    [InlineData(180, 0.25f, 0.25f, 2)]
    [InlineData(270, 0.25f, 0.25f, 1)]
    [InlineData(-90, 0.25f, 0.25f, 1)]
    [InlineData(90, 0.75f, 0.25f, 2)]
    public void A_placed_texture_turns_uv_counter_clockwise_about_its_origin(float degrees, float u, float v, float expected) =>
        Assert.Equal(expected, Red(new PlacedTexture(Texture(Interpolation.Nearest, Wrapping.Repeat), Vector2.One, degrees, Vector2.Zero), u, v));

    [Fact]
    public void A_placed_texture_is_scaled_then_turned_then_moved()
    {
        // (0.3, 0.1) → (0.6, −0.1) → (0.1, 0.6) → (0.6, 0.6).
        PlacedTexture texture = new(Texture(Interpolation.Nearest, Wrapping.Clamp), new(2, -1), 90, new(0.5f, 0));
        Assert.Equal(2, Red(texture, 0.3f, 0.1f));
    }

    [Fact]
    public void Scale_and_offset_move_uv()
    {
        ImageTexture texture = new(s_four, Interpolation.Nearest, Wrapping.Repeat, new(2, 1), new(0.5f, 0));
        Assert.Equal(2, Red(texture, 0.1f, 0.75f));
        Assert.Equal(1, Red(texture, 0.3f, 0.75f));
    }

    [Fact]
    public void No_coordinate_reads_outside_the_picture()
    {
        foreach (Wrapping wrapping in Enum.GetValues<Wrapping>())
        {
            foreach (float u in new[] { float.NaN, float.PositiveInfinity, float.NegativeInfinity, 1e30f, -1e30f, float.Epsilon, -float.Epsilon })
            {
                foreach (Interpolation interpolation in Enum.GetValues<Interpolation>())
                {
                    Texture(interpolation, wrapping).Evaluate(u, u, out _);
                }
            }

            Assert.InRange(Red(Texture(Interpolation.Nearest, wrapping), float.NaN, 0.5f), 1, 4);
        }
    }

    [Theory]
    [InlineData(0.1f, 0.1f, 1)]
    [InlineData(0.3f, 0.1f, 0)]
    [InlineData(0.3f, 0.3f, 1)]
    [InlineData(-0.1f, 0.1f, 0)]
    public void Checkers_alternate_in_both_directions(float u, float v, float expected)
    {
        CheckerTexture texture = new(new SolidTexture(Rgb.White), new SolidTexture(Rgb.Black), new(4, 4), Vector2.Zero);
        Assert.Equal(expected, Red(texture, u, v));
    }

    [Fact]
    public void A_placed_textures_matrix_comes_first()
    {
        // (0.1, 0.2) → (0.1 + 2 · 0.2 + 0.05, 0.5 · 0.1 + 0.2 − 0.3) = (0.55, −0.05) → (1.1, −0.05).
        PlacedTexture texture = new(new UvTexture(), new(2, 1), 0, Vector2.Zero) { Matrix = [1, 2, 0.05f, 0.5f, 1, -0.3f] };
        texture.Evaluate(0.1f, 0.2f, out RgbW color);
        Assert.Equal(1.1f, color.R[0], 1e-6f);
        Assert.Equal(-0.05f, color.G[0], 1e-6f);
    }

    [Theory]
    [InlineData(GradientShape.Linear, -1, 0.3f, 0)]
    [InlineData(GradientShape.Linear, 0.25f, 0.3f, 0.25)]
    [InlineData(GradientShape.Linear, 7, 0.3f, 1)]
    [InlineData(GradientShape.Radial, 0.5f, 0.5f, 0)]
    [InlineData(GradientShape.Radial, 0.65f, 0.7f, 0.5)]
    [InlineData(GradientShape.Radial, 0, 0, 1)]
    [InlineData(GradientShape.Angular, 0.9f, 0.5f, 0)]
    [InlineData(GradientShape.Angular, 0.5f, 0.9f, 0.25)]
    [InlineData(GradientShape.Angular, 0.2f, 0.5f, 0.5)]
    [InlineData(GradientShape.Angular, 0.6f, 0.4f, 0.875)]
    public void Gradients_grow_along_their_shape(GradientShape shape, float u, float v, double expected) =>
        Assert.Equal(expected, Red(new GradientTexture(shape, new SolidTexture(Rgb.Black), new SolidTexture(Rgb.White)), u, v), 6);

    [Theory]
    [InlineData(0.125f, 0.5f, 0)]
    [InlineData(0.04f, 0.5f, 1)]
    [InlineData(0.06f, 0.5f, 0)]
    [InlineData(0.21f, 0.5f, 1)]
    [InlineData(0.125f, 0.03f, 1)]
    [InlineData(0.125f, 0.96f, 1)]
    [InlineData(0.125f, 1.5f, 1)]
    [InlineData(0.25f, 1.5f, 0)]
    [InlineData(-0.125f, -0.5f, 1)]
    [InlineData(0, -0.5f, 0)]
    public void Bricks_lie_in_courses_that_are_shifted(float u, float v, float expected)
    {
        // Four bricks and one course in uv; the mortar is a tenth of a course thick, so 0.05 of uv on each side.
        BrickTexture texture = new(new SolidTexture(Rgb.Black), new SolidTexture(Rgb.White), new(4, 1), 0.1f, 0.5f);
        Assert.Equal(expected, Red(texture, u, v * 0.999f));
    }

    [Fact]
    public void A_mix_goes_from_one_texture_to_the_other()
    {
        Texture weight = new PlacedTexture(new UvTexture(), Vector2.One, 0, Vector2.Zero);
        MixTexture texture = new(new SolidTexture(new(1, 0, 0)), new SolidTexture(new(3, 0, 0)), weight);
        Assert.Null(texture.Constant);
        Assert.Equal(TextureInputs.Uv, texture.Inputs);
        foreach ((float u, float expected) in new[] { (-1f, 1f), (0f, 1f), (0.25f, 1.5f), (1f, 3f), (2f, 3f) })
        {
            Assert.Equal(expected, Red(texture, u, 0.9f));
        }

        MixTexture constant = new(new SolidTexture(new(1, 0, 0)), new SolidTexture(new(3, 1, 0)), new SolidTexture(new(0.5f, 0, 0)));
        Assert.Equal((new Rgb(2, 0.5f, 0), TextureInputs.None), (constant.Constant!.Value, constant.Inputs));
    }

    [Fact]
    public void Pictures_are_read_raw_where_they_stand_for_numbers_unless_they_say_otherwise()
    {
        List<(string, bool)> read = [];
        RayTracer.Description.SceneBuilder builder = new((path, raw) =>
        {
            read.Add((path, raw));
            return s_four;
        });
        ImageTextureDescription either = new() { File = "either" };
        builder.Texture(either);
        builder.NumberTexture(either);
        builder.NumberTexture(either);
        builder.NumberTexture(new ProductTextureDescription { First = new ImageTextureDescription { File = "inner" }, Second = new ImageTextureDescription { File = "decoded", Raw = false } });
        builder.Texture(new ImageTextureDescription { File = "raw", Raw = true });
        builder.Texture(new MixTextureDescription { First = either, Weight = either });
        Assert.Equal([("either", false), ("either", true), ("inner", true), ("decoded", false), ("raw", true)], read);
    }

    private static ImageTexture Texture(Interpolation interpolation, Wrapping wrapping) =>
        new(s_four, interpolation, wrapping, Vector2.One, Vector2.Zero);

    private static float Red(Texture texture, float u, float v)
    {
        texture.Evaluate(u, v, out RgbW color);
        return color.R[0];
    }
}
