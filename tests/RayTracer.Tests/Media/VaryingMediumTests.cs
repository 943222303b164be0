using System.Numerics;
using RayTracer.Media;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Tests.Media;

/// <summary>
/// The numbers of grids between their points, and their majorants.
/// Covers `PlacedGrid`, `VaryingMedium` and `FlightW`.
/// </summary>
public unsafe class VaryingMediumTests
{
    private static readonly Transform s_place = Transform.Translation(new(3, -2, 5)) * Transform.Rotation(new(1, 2, 3), 40) * Transform.Scaling(new(4, -3, 2));

    public static TheoryData<GridInterpolation, Wrapping, int> Kinds()
    {
        TheoryData<GridInterpolation, Wrapping, int> kinds = [];
        foreach (GridInterpolation interpolation in Enum.GetValues<GridInterpolation>())
        {
            foreach (Wrapping wrapping in Enum.GetValues<Wrapping>())
            {
                kinds.Add(interpolation, wrapping, 1);
                kinds.Add(interpolation, wrapping, 3);
            }
        }

        return kinds;
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void Nothing_in_a_cell_is_above_its_majorant_or_below_its_minorant(GridInterpolation interpolation, Wrapping wrapping, int channels)
    {
        Random random = new(5 + TestSettings.Seed);
        VolumeGrid grid = Grid(70, 9, 33, channels, random);
        VaryingMedium medium = new(new(grid, s_place, interpolation, wrapping), null, new(0.5f, 2, 1), Rgb.White);
        Assert.Equal(2, medium.CellSize);
        for (int i = 0; i < 2000; i++)
        {
            // Close to the borders of cells as well.
            Vector3 at = new(random.NextSingle() * 70, random.NextSingle() * 9, random.NextSingle() * 33);
            at = i % 2 == 0 ? at : new Vector3(float.Round(at.X / 2) * 2, float.Round(at.Y / 2) * 2, float.Round(at.Z / 2) * 2) + new Vector3((random.NextSingle() - 0.5f) * 0.01f);
            at = Vector3.Clamp(at, Vector3.Zero, new(69.99f, 8.99f, 32.99f));
            medium.Extinction(at, default, out RgbW extinction);
            int cell = (int)(at.X / 2) + (medium.CellCounts.X * ((int)(at.Y / 2) + (medium.CellCounts.Y * (int)(at.Z / 2))));
            float largest = float.Max(extinction.R[0], float.Max(extinction.G[0], extinction.B[0]));
            Assert.True(largest <= medium.Most[cell] * 1.000001f, $"{largest} at {at}, majorant {medium.Most[cell]}");
            Assert.True(channels == 3 ? medium.Least[cell] == 0 : extinction.G[0] >= medium.Least[cell] * 0.999999f, $"{extinction.G[0]} at {at}, minorant {medium.Least[cell]}");
        }
    }

    [Fact]
    public void Points_of_a_grid_stand_in_the_middle_of_voxels_and_between_them_all_is_linear()
    {
        VolumeGrid grid = new(2, 3, 2, 1, [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12]);
        PlacedGrid linear = new(grid, s_place, GridInterpolation.Trilinear, Wrapping.Clamp);
        Assert.Equal(1, At(linear, new(0.5f, 0.5f, 0.5f)));
        Assert.Equal(10, At(linear, new(1.5f, 1.5f, 1.5f)));
        Assert.Equal((1 + 2 + 3 + 4 + 7 + 8 + 9 + 10) / 8f, At(linear, new(1, 1, 1)), 1e-5f);
        Assert.Equal(1, At(linear, new(0.1f, 0, 0.3f)));
        Assert.Equal(1.5f, At(new(grid, s_place, GridInterpolation.Trilinear, Wrapping.Repeat), new(0, 0.5f, 0.5f)));
        Assert.Equal(1, At(new(grid, s_place, GridInterpolation.Trilinear, Wrapping.Mirror), new(0, 0.5f, 0.5f)));
        Assert.Equal(2, At(new(grid, s_place, GridInterpolation.Nearest, Wrapping.Clamp), new(1.01f, 0.99f, 0.2f)));
        Vector3 world = s_place.Point(new(0.75f, 0.5f, 0.25f));
        Vector3 voxels = linear.ToVoxels.Point(world);
        Assert.Equal(1.5f, voxels.X, 1e-4f);
        Assert.Equal(1.5f, voxels.Y, 1e-4f);
        Assert.Equal(0.5f, voxels.Z, 1e-4f);
    }

    [Fact]
    public void Rays_cross_the_whole_box_and_find_all_of_the_least_extinction()
    {
        // Without a place at which anything may happen, what is left is the sum over cells of minorant times length: of an even grid, all of it.
        VolumeGrid grid = new(64, 64, 64, 1, [.. Enumerable.Repeat(0.25f, 64 * 64 * 64)]);
        VaryingMedium medium = new(new(grid, s_place, GridInterpolation.Trilinear, Wrapping.Clamp), null, new(2, 2, 2), Rgb.White);
        Random random = new(6 + TestSettings.Seed);
        PinnedBuffer<FlightW> flight = new(1);
        for (int i = 0; i < 200; i++)
        {
            Vector3 from = s_place.Point(new Vector3(random.NextSingle(), random.NextSingle(), random.NextSingle()) * 3 - Vector3.One);
            Vector3 to = s_place.Point(new(random.NextSingle(), random.NextSingle(), random.NextSingle()));
            Vector3 direction = i % 4 == 0 ? Vector3.Normalize(s_place.Vector(Vector3.UnitX)) : Vector3.Normalize(to - from);
            MaskW meets = flight.Pointer->Begin(medium, from, direction, 1e6f);
            flight.Pointer->Depth = 1;
            Assert.False(flight.Pointer->Seek(medium, meets, aboveBase: true).Any);
            float expected = meets.Any ? 0.5f * flight.Pointer->End[0] : 0;
            Assert.Equal(expected, flight.Pointer->BaseDepth[0], 1e-4f * (1 + expected));
            Assert.True(meets.Any || i % 4 == 0, $"ray {i} is aimed at the box and misses it");
        }
    }

    [Theory]
    [InlineData(0, 1, 1, 1)]
    [InlineData(1, 1, 5000, 1)]
    [InlineData(1, 1, 1, 2)]
    public void Grids_that_cannot_be_are_refused(int x, int y, int z, int channels) => Assert.Throws<ArgumentException>(() => new VolumeGrid(x, y, z, channels, []));

    [Theory]
    [InlineData(-1)]
    [InlineData(float.NaN)]
    [InlineData(float.PositiveInfinity)]
    public void Numbers_that_no_density_can_be_are_refused(float value) => Assert.Throws<ArgumentException>(() => new VolumeGrid(1, 1, 1, 1, [value]));

    private static VolumeGrid Grid(int x, int y, int z, int channels, Random random) =>
        new(x, y, z, channels, [.. Enumerable.Range(0, x * y * z * channels).Select(_ => random.NextSingle())]);

    private static float At(PlacedGrid grid, Vector3 at)
    {
        grid.Value(at, out RgbW value);
        return value.R[0];
    }
}
