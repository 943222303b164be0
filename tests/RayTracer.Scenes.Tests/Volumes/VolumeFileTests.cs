using System.Buffers.Binary;
using System.Numerics;
using RayTracer.Description;
using RayTracer.Media;

namespace RayTracer.Scenes.Tests;

/// <summary>
/// Files of grids.
/// Covers `VolReader`, `RawGridReader`, `NanoVdbReader` and `NanoVdbTree`.
/// </summary>
public class VolumeFileTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(3)]
    [InlineData(6)]
    public void Vol_files_have_their_numbers_in_their_order(int channels)
    {
        byte[] file = TestVolumes.Vol(3, 4, 5, (x, y, z) => [.. Enumerable.Range(0, channels).Select(c => x + (10f * y) + (100 * z) + (1000 * c))]);
        VolumeGrid grid = VolumeFile.Read(file, GridFormat.Vol, new());
        Assert.Equal((3, 4, 5, channels), (grid.Width, grid.Height, grid.Depth, grid.Channels));
        Assert.Equal(2 + 30 + 400, Value(grid, 2, 3, 4, 0));
        Assert.Equal(1 + 20 + 300 + (1000 * (channels - 1)), Value(grid, 1, 2, 3, channels - 1));
    }

    [Theory]
    [InlineData(GridNumbers.UInt8, new byte[] { 0, 255, 51, 102 }, 0.4f)]
    [InlineData(GridNumbers.UInt16, new byte[] { 0, 0, 255, 255, 0, 0, 0x33, 0x33 }, 0.2f)]
    [InlineData(GridNumbers.Float16, new byte[] { 0, 0, 0, 0x3c, 0, 0, 0, 0x38 }, 0.5f)]
    [InlineData(GridNumbers.Float32, new byte[] { 0, 0, 0, 0, 0, 0, 0x80, 0x3f, 0, 0, 0, 0, 0, 0, 0x80, 0x3e }, 0.25f)]
    public void Files_of_numbers_are_read_by_their_kind(GridNumbers kind, byte[] bytes, float last)
    {
        VolumeGrid grid = VolumeFile.Read(bytes, GridFormat.Raw, new() { Size = [2, 2, 1], Numbers = kind });
        Assert.Equal(0, Value(grid, 0, 0, 0, 0));
        Assert.Equal(1, Value(grid, 1, 0, 0, 0));
        Assert.Equal(last, Value(grid, 1, 1, 0, 0));
    }

    [Theory]
    [InlineData(0, 3)]
    [InlineData(1, 3)]
    [InlineData(0, -20)]
    [InlineData(1, -128)]
    public void NanoVdb_trees_become_the_box_of_their_active_voxels(int codec, int first)
    {
        byte[] file = TestNanoVdb.File((first, first + 1, first + 2), (first + 10, first + 12, first + 14), (x, y, z) => 1000 + x + (0.25f * y) + (0.0625f * z), codec);
        VolumeGrid grid = VolumeFile.Read(file, GridFormat.NanoVdb, new());
        Assert.Equal((11, 12, 13, 1), (grid.Width, grid.Height, grid.Depth, grid.Channels));
        Assert.Equal(1000 + first + (0.25f * (first + 1)) + (0.0625f * (first + 2)), Value(grid, 0, 0, 0, 0));
        Assert.Equal(1000 + first + 10 + (0.25f * (first + 8)) + (0.0625f * (first + 11)), Value(grid, 10, 7, 9, 0));

        // A voxel's middle is where the file's map has its number.
        Vector3 middle = grid.Place!.Value.Point(new(2.5f / 11, 0.5f / 12, 0.5f / 13));
        Assert.Equal(10 + (0.25f * (first + 2)), middle.X, 1e-4);
        Assert.Equal(20 + (0.25f * (first + 1)), middle.Y, 1e-4);
        Assert.Equal(30 + (0.25f * (first + 2)), middle.Z, 1e-4);
    }

    [Fact]
    public void A_grid_is_found_by_its_name()
    {
        byte[] file = TestNanoVdb.File((0, 0, 0), (7, 7, 7), (_, _, _) => 1);
        Assert.Equal(8, VolumeFile.Read(file, GridFormat.NanoVdb, new() { Name = "density" }).Width);
        Refused("it has no grid of floats called \"heat\": it has \"density\" (float)", file, GridFormat.NanoVdb, new() { Name = "heat" });
    }

    [Fact]
    public void What_is_not_read_is_said()
    {
        byte[] vol = TestVolumes.Vol(2, 2, 2, (_, _, _) => [1]);
        Refused("it is not one of Mitsuba's .vol files: it does not begin with VOL and a header", vol[..40], GridFormat.Vol);
        Refused("it is of version 2 of the format, but only 3 is read", With(vol, 3, 2), GridFormat.Vol);
        Refused("its numbers are of kind 3, but only floats (1) are read", With(vol, 4, 3), GridFormat.Vol);
        Refused("a grid has 1, 3 or 6 channels, not 5", With(vol, 20, 5), GridFormat.Vol);
        Refused("a grid has from 1 to 4096 points along each axis, not 0×2×2", With(vol, 8, 0), GridFormat.Vol);
        Refused("2×2×9 points with 1 channels need 144 bytes, but 32 follow the header", With(vol, 16, 9), GridFormat.Vol);
        Refused("it has the number -1, but none may be negative or infinite", TestVolumes.Vol(2, 2, 2, (_, _, _) => [-1]), GridFormat.Vol);
        Refused("the file says its size itself: leave out \"size\"", vol, GridFormat.Vol, new() { Size = [2, 2, 2] });
        Refused("a file of nothing but numbers needs \"size\", its points along x, y and z (files that say it themselves end in .vol or .nvdb)", vol, GridFormat.Raw);
        Refused("\"size\" has 3 numbers, or 4 with the channels, not 2", vol, GridFormat.Raw, new() { Size = [2, 2] });
        Refused("2×2×3 numbers of 4 bytes are 48 bytes, but the file has 80", vol, GridFormat.Raw, new() { Size = [2, 2, 3] });
        Refused("a grid has from 1 to 4096 points along each axis, not -2×2×3", vol, GridFormat.Raw, new() { Size = [-2, 2, 3] });
        Refused("a grid has at most 1,073,741,824 numbers, not 68,719,476,736", vol, GridFormat.Raw, new() { Size = [4096, 4096, 4096] });
        Refused("it is compressed with Blosc, which is not read: write it uncompressed, or with ZIP (nanovdb_convert --zip)", Cube(2), GridFormat.NanoVdb);
        Refused("its active voxels span 1×1×1000000000, too many for so small a file", Sparse(), GridFormat.NanoVdb);
        Refused("it has no grid of floats: it has \"density\" (vec3f)", Cube(0, type: 6), GridFormat.NanoVdb);
        Refused("it is not one of NanoVDB's files: a part of it does not begin with NanoVDB0 or NanoVDB2", With(Cube(0), 0, 1), GridFormat.NanoVdb);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    public void Every_beginning_of_a_file_ends_in_a_message(int codec)
    {
        byte[] file = Cube(codec);
        foreach (int length in Enumerable.Range(0, 1200).Concat(Enumerable.Range(1, 40).Select(i => file.Length - (i * i))).Where(n => n >= 0 && n < file.Length))
        {
            Assert.Throws<VolumeException>(() => VolumeFile.Read(file.AsSpan(0, length), GridFormat.NanoVdb, new()));
        }
    }

    [Theory]
    [InlineData("vol")]
    [InlineData("nvdb")]
    [InlineData("zip")]
    [Trait("Category", "Thorough")]
    public void Mutated_files_end_in_a_grid_or_a_message(string kind)
    {
        byte[] good = kind == "vol" ? TestVolumes.Vol(5, 6, 7, (x, y, z) => [x + y + z]) : Cube(kind == "zip" ? 1 : 0);
        GridFormat format = kind == "vol" ? GridFormat.Vol : GridFormat.NanoVdb;
        Random random = new(2027 + TestSettings.Seed);
        (int read, int refused) = (0, 0);
        for (int i = 0; i < TestSettings.Scale(500, 5000); i++)
        {
            byte[] bad = Mutate(good, random);
            SceneBudget budget = new();
            using IDisposable counted = budget.Begin();
            long before = GC.GetAllocatedBytesForCurrentThread();
            System.Diagnostics.Stopwatch watch = System.Diagnostics.Stopwatch.StartNew();
            try
            {
                _ = VolumeFile.Read(bad, format, new());
                read++;
            }
            catch (VolumeException)
            {
                refused++;
            }

            long allocated = GC.GetAllocatedBytesForCurrentThread() - before;
            Assert.True(allocated <= 1L << 30, $"mutant {i} took {allocated} bytes");
            Assert.True(watch.Elapsed < TimeSpan.FromSeconds(60), $"mutant {i} took {watch.Elapsed}");
        }

        Assert.NotEqual(0, read);
        Assert.NotEqual(0, refused);
    }

    private static byte[] Cube(int codec, uint type = 1) => TestNanoVdb.File((0, 0, 0), (7, 7, 7), (x, y, z) => x + y + z, codec, type);

    // The last active voxel along z, in the root's header.
    private static byte[] Sparse()
    {
        byte[] file = TestNanoVdb.File((0, 0, 0), (0, 0, 0), (_, _, _) => 1);
        BinaryPrimitives.WriteInt32LittleEndian(file.AsSpan(16 + 176 + 8 + 672 + 64 + 20), 999_999_999);
        return file;
    }

    private static byte[] With(byte[] file, int at, byte value)
    {
        byte[] changed = [.. file];
        changed[at] = value;
        return changed;
    }

    // Most of what decides stands in few places: the headers, and the tables of nodes.
    private static byte[] Mutate(byte[] good, Random random)
    {
        byte[] changed = [.. good];
        int[] heads = [good.Length, int.Min(good.Length, 250), int.Min(good.Length, 1100)];
        for (int edit = random.Next(1, 4); edit > 0; edit--)
        {
            int at = random.Next(heads[random.Next(heads.Length)]);
            switch (random.Next(3))
            {
                case 0:
                    changed[at] = (byte)random.Next(256);
                    break;
                case 1:
                    changed[at] ^= (byte)(1 << random.Next(8));
                    break;
                default:
                    int[] numbers = [0, 1, -1, int.MaxValue, int.MinValue, 4096, 65536, random.Next()];
                    if (at + 4 <= changed.Length)
                    {
                        BinaryPrimitives.WriteInt32LittleEndian(changed.AsSpan(at), numbers[random.Next(numbers.Length)]);
                    }

                    break;
            }
        }

        return random.Next(8) == 0 ? changed[..random.Next(changed.Length)] : changed;
    }

    private static void Refused(string message, byte[] bytes, GridFormat format, GridDescription? description = null) =>
        Assert.Equal(message, Assert.Throws<VolumeException>(() => VolumeFile.Read(bytes, format, description ?? new())).Message);

    private static float Value(VolumeGrid grid, int x, int y, int z, int channel) =>
        grid.Values[(((((z * grid.Height) + y) * grid.Width) + x) * grid.Channels) + channel];
}
