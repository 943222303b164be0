using System.Numerics;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics.X86;
using System.Security.Cryptography;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.RenderTests.Bits;

namespace RayTracer.RenderTests;

/// <summary>
/// What a test runs as another process, with other settings of the runtime: prints which instructions there are, then the name
/// and the hash of each small picture.
/// </summary>
internal static class Program
{
    /// <param name="args">Tile edge (of the tile in the middle of each picture; 0 for all of it), then names of scenes.</param>
    public static void Main(string[] args)
    {
        Console.WriteLine($"lanes={Vector<float>.Count} avx2={Avx2.IsSupported} avx512={Avx512F.IsSupported}");
        foreach (string name in args.Skip(1))
        {
            Console.WriteLine($"{name} {Hash(name, int.Parse(args[0]))}");
        }
    }

    /// <summary>The hash of a picture, or of a tile in its middle.</summary>
    /// <param name="name">One of <see cref="BitScenes.Pictures"/>.</param>
    /// <param name="edge">Edge of the tile in pixels; 0 for all of the picture.</param>
    public static string Hash(string name, int edge)
    {
        if (BitScenes.Auxiliary.Contains(name))
        {
            return HashOfAuxiliaryImages(BitScenes.Load(name["aov/".Length..]));
        }

        if (BitScenes.Denoised.Contains(name))
        {
            return HashOfDenoised(BitScenes.Load(name["denoised/".Length..]));
        }

        Scene scene = BitScenes.Load(name);
        Tile middle = new((scene.Render.Width - edge) / 2, (scene.Render.Height - edge) / 2, edge, edge);
        return new RTracer(scene, new() { Crop = edge > 0 ? middle : null, Threads = 2 }).Render().Film.ComputeHash();
    }

    private static string HashOfDenoised(Scene scene)
    {
        Film film = new(scene.Render.Width, scene.Render.Height, FilmPlane.Half);
        new RTracer(scene, new() { Threads = 2 }).Render(film);
        (HalfRender first, HalfRender second) = HalfRender.Of(scene, new() { Threads = 2 }, film);
        float[] pixels = Denoiser.Denoise(first, second, 2).Picture.Pixels;
        return Convert.ToHexStringLower(SHA256.HashData(MemoryMarshal.AsBytes<float>(pixels)));
    }

    private static string HashOfAuxiliaryImages(Scene scene)
    {
        AovFilm film = new(new(scene.Render.Width, scene.Render.Height), AuxiliaryImage.Known.All.OfType<FirstHitImage>());
        new FirstHitPass(scene, new() { Threads = 2 }).Render(film);
        using IncrementalHash hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        foreach (AuxiliaryImage kind in film.Images)
        {
            double[] row = new double[film.Width * kind.Letters.Length];
            for (int y = 0; y < film.Height; y++)
            {
                film.ReadRow(kind, y, row);
                hash.AppendData(MemoryMarshal.AsBytes(row.AsSpan()));
            }
        }

        return Convert.ToHexStringLower(hash.GetHashAndReset());
    }
}
