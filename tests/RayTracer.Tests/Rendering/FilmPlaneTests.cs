using RayTracer.Description;
using RayTracer.Rendering;
using RayTracer.Testing;

namespace RayTracer.Tests;

/// <summary>Covers <see cref="FilmPlane"/> and the planes of films.</summary>
public class FilmPlaneTests
{
    [Fact]
    public void Halves_take_turns_in_blocks_that_grow_to_64()
    {
        bool[] isOfHalf = [.. Enumerable.Range(0, 1024).Select(FilmPlane.IsOfHalf)];
        Assert.Equal("0101001100001111", string.Concat(isOfHalf.Take(16).Select(b => b ? '0' : '1')));
        for (int samples = 2; samples <= isOfHalf.Length; samples *= 2)
        {
            Assert.Equal(samples / 2, isOfHalf.Take(samples).Count(b => b));
        }

        int length = 1;
        int longest = 1;
        for (int i = 1; i < isOfHalf.Length; i++)
        {
            length = isOfHalf[i] == isOfHalf[i - 1] ? length + 1 : 1;
            longest = Math.Max(longest, length);
        }

        Assert.Equal(64, longest);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(8)]
    [InlineData(5)]
    public void A_half_is_the_film_of_its_samples_to_the_bit(int tileSize)
    {
        Scene scene = Bright();
        Film film = new(Width(scene), Height(scene), FilmPlane.Half);
        Film[] halves = [new(Width(scene), Height(scene)), new(Width(scene), Height(scene))];
        foreach (SampleRange range in (SampleRange[])[new(3, 70), new(0, 3), new(70, 80)])
        {
            new RTracer(scene, new() { Samples = range, TileSize = tileSize, Threads = 2 }).Render(film);
        }

        for (int sample = 0; sample < scene.Render.SamplesPerPixel; sample++)
        {
            new RTracer(scene, new() { Samples = new(sample, sample + 1) }).Render(halves[FilmPlane.IsOfHalf(sample) ? 0 : 1]);
        }

        (Film first, Film second) = film.Halves();
        Assert.Equal(halves.Select(h => h.ComputeHash()), [first.ComputeHash(), second.ComputeHash()]);
        Assert.Equal(new RTracer(scene).Render().Film.ComputeHash(), film.ComputeHash([]));
    }

    [Fact]
    public void Pixels_with_different_numbers_of_samples_have_halves_too()
    {
        Scene scene = Bright();
        SamplePlan plan = new(new(0, 0, 19, 11), [new(0, 0, 10, 11), new(10, 0, 9, 11)], [5, 77], 0, new());
        Film film = new(Width(scene), Height(scene), FilmPlane.Half);
        new PlannedRender(scene, new(), plan).Render(film);
        (Film first, Film second) = film.Halves();
        for (int pixel = 0; pixel < film.Width * film.Height; pixel++)
        {
            (int y, int x) = int.DivRem(pixel, film.Width);
            uint all = film.SampleCount(x, y);
            Assert.Equal(x < 10 ? 5u : 77u, all);
            Assert.Equal((uint)Enumerable.Range(0, (int)all).Count(FilmPlane.IsOfHalf), first.SampleCount(x, y));
            Assert.Equal(all - first.SampleCount(x, y), second.SampleCount(x, y));
        }
    }

    [Fact]
    public void The_hash_covers_planes_where_there_are_any()
    {
        Film plain = new(2, 2);
        Film film = new(2, 2, FilmPlane.Half);
        Assert.Equal(plain.ComputeHash(), film.ComputeHash([]));
        Assert.NotEqual(plain.ComputeHash(), film.ComputeHash());
        string empty = film.ComputeHash();
        Int128[] sums = new Int128[10];
        sums[9] = 1;
        film.AddPlane(FilmPlane.Half, 1, sums);
        Assert.NotEqual(empty, film.ComputeHash());
        film.Clear();
        Assert.Equal(empty, film.ComputeHash());
    }

    [Fact]
    public void A_plane_is_merged_and_one_that_is_missing_is_refused()
    {
        Film film = new(1, 1, FilmPlane.Half);
        Film other = new(1, 1, FilmPlane.Half);
        other.AddPlane(FilmPlane.Half, 0, (ReadOnlySpan<long>)[1, 2, 3, 4, 5]);
        film.Merge(other);
        film.Merge(other);
        Int128[] sums = new Int128[5];
        film.ReadPlane(FilmPlane.Half, 0, sums);
        Assert.Equal([2, 4, 6, 8, 10], sums);
        Assert.Throws<ArgumentException>(() => film.Merge(new Film(1, 1)));
        Assert.Throws<ArgumentException>(() => new Film(1, 1).Halves());

        // What a film has no plane for is left out.
        new Film(1, 1).Merge(film);
    }

    [Fact]
    public void A_name_with_other_sums_is_another_plane()
    {
        Assert.Same(FilmPlane.Half, FilmPlane.Of("half", ["red", "green", "blue", "square", "count"]));
        Assert.False(FilmPlane.Of("half", ["red"]).IsKnown);
        Assert.False(FilmPlane.Of("whole", FilmPlane.Half.Sums).IsKnown);
    }

    [Fact]
    public void An_integrator_that_traces_light_has_planes_for_it()
    {
        Assert.Equal([], FilmPlane.Needed(Integrator.Path, noise: true));
        Assert.Equal([FilmPlane.Half], FilmPlane.Needed(Integrator.Path, halves: true));
        Integrator light = new LightIntegrator();
        Assert.Equal([FilmPlane.Light], FilmPlane.Needed(light));
        Assert.Equal([FilmPlane.Light, FilmPlane.LightSquare], FilmPlane.Needed(light, noise: true));
        Assert.Equal([FilmPlane.Half, FilmPlane.Light, FilmPlane.LightSquare, FilmPlane.LightHalf], FilmPlane.Needed(light, halves: true));

        // What a pixel takes beside the camera's samples: 96 bytes for its light, and as many again with its noise and halves.
        Assert.InRange(Bytes(light) + SplatSums.BytesPerPixel, 1, 96);
        Assert.InRange(Bytes(light, hasHalves: true) - Bytes(Integrator.Path, hasHalves: true) + SplatSums.BytesPerPixel, 1, 192);
    }

    private static int Bytes(Integrator integrator, bool hasHalves = false) => 16 * FilmPlane.Needed(integrator, hasHalves).Sum(p => p.Sums.Count);

    private sealed class LightIntegrator() : Integrator("lit", IntegratorTraits.TracesLight)
    {
        protected internal override SurfaceShader CreateShader(ShaderContext context) => Path.CreateShader(context);
    }

    private static int Width(Scene scene) => scene.Render.Width;

    private static int Height(Scene scene) => scene.Render.Height;

    // With samples that are too bright for the sums of a tile.
    private static Scene Bright() => TestScenes.Build("""
        { "render": { "integrator": "path", "width": 19, "height": 11, "samplesPerPixel": 80 }, "camera": { "position": [0, 1, 5], "lookAt": [0, 0.5, 0] }, "shapes": [
          { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0] },
          { "type": "sphere", "center": [0, 0.5, 0], "radius": 0.5, "material": { "type": "dielectric" } },
          { "type": "sphere", "center": [1.2, 1.4, 0], "radius": 0.3, "material": { "type": "luminaire", "multiplier": 900 } }] }
        """);
}
