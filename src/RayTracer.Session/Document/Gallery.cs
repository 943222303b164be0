using System.Security.Cryptography;
using System.Text;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>
/// The scenes that come with the program, with small pictures: those of shipped scenes are shipped too, those of scenes that somebody has changed or added are
/// rendered and kept.
/// </summary>
public sealed class Gallery : IDisposable
{
    private const int ThumbnailWidth = 240;
    private const int ThumbnailHeight = 180;
    private const int ThumbnailSamples = 16;
    private const int ShippedSamples = 64;
    private const int ShippedQuality = 82;
    private const int MostKept = 500;

    private readonly UserFolders _folders;
    private readonly Dictionary<string, string> _paths = new(StringComparer.Ordinal);
    private readonly SemaphoreSlim _one = new(1);
    private readonly CancellationTokenSource _end = new();

    /// <summary>Looks for the scenes.</summary>
    /// <param name="folders">The folders in which pictures are kept.</param>
    /// <param name="scenes">The folder of the scenes; null for the one that comes with the program.</param>
    public Gallery(UserFolders folders, string? scenes = null)
    {
        _folders = folders;
        string? folder = scenes ?? ScenesFolder.Find();
        Groups = folder is null || !Directory.Exists(folder) ? [] : [.. FindGroups(folder)];
    }

    /// <summary>The scenes, those of the report first.</summary>
    public IReadOnlyList<GalleryGroup> Groups { get; }

    /// <summary>A scene's small picture, of at most 240 × 180 pixels, as a PNG or JPEG file. One is made at a time.</summary>
    /// <param name="id">Which scene.</param>
    /// <param name="cancellation">Ends the waiting.</param>
    /// <exception cref="SessionException">There is no such scene, or it cannot be rendered.</exception>
    public async Task<byte[]> Thumbnail(string id, CancellationToken cancellation = default)
    {
        string path = PathOf(id);
        if (Shipped(ShippedName(id, path)) is { } shipped)
        {
            return shipped;
        }

        string kept = Path.Combine(_folders.Thumbnails, Fingerprint(path) + ".png");
        using CancellationTokenSource either = CancellationTokenSource.CreateLinkedTokenSource(cancellation, _end.Token);
        await _one.WaitAsync(either.Token).ConfigureAwait(false);
        try
        {
            if (File.Exists(kept))
            {
                return await File.ReadAllBytesAsync(kept, either.Token).ConfigureAwait(false);
            }

            byte[] png = await Task.Factory.StartNew(() => Render(path, either.Token), either.Token, TaskCreationOptions.LongRunning, TaskScheduler.Default).ConfigureAwait(false);
            Keep(kept, png);
            return png;
        }
        catch (IOException e)
        {
            throw new SessionException($"the picture of {id} cannot be read: {e.Message.TrimEnd('.')}", e);
        }
        finally
        {
            _one.Release();
        }
    }

    /// <summary>Ends the making of pictures, and waits for the one that is being made, which may write its file still.</summary>
    public void Dispose()
    {
        if (!_end.IsCancellationRequested)
        {
            _end.Cancel();
            _one.Wait();
        }
    }

    /// <summary>The file of a scene.</summary>
    /// <exception cref="SessionException">There is no such scene.</exception>
    internal string PathOf(string id) =>
        _paths.TryGetValue(id, out string? path) ? path : throw new SessionException($"the gallery has no scene {JsonLayout.Quote(id)}");

    /// <summary>The name that a scene's shipped picture has as long as its text is the shipped one, whatever its line ends.</summary>
    internal static string ShippedName(string id, string path)
    {
        string text = File.ReadAllText(path).ReplaceLineEndings("\n");
        return $"{Path.ChangeExtension(id, null).Replace('/', '.')}.{Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(text)))[..12]}.jpg";
    }

    /// <summary>Renders the picture of a scene that is to be shipped.</summary>
    internal byte[] MakeShipped(string id)
    {
        using MemoryStream jpeg = new();
        Render(PathOf(id), ShippedSamples, picture => JpegWriter.Write(jpeg, picture, ShippedQuality), default);
        return jpeg.ToArray();
    }

    private static byte[]? Shipped(string name)
    {
        using Stream? found = typeof(Gallery).Assembly.GetManifestResourceStream("thumbnails/" + name);
        if (found is null)
        {
            return null;
        }

        byte[] bytes = new byte[found.Length];
        found.ReadExactly(bytes);
        return bytes;
    }

    private static byte[] Render(string path, CancellationToken cancellation)
    {
        Thread.CurrentThread.Priority = ThreadPriority.BelowNormal;
        using MemoryStream png = new();
        Render(path, ThumbnailSamples, picture => PngWriter.Write(png, picture), cancellation);
        return png.ToArray();
    }

    private static void Render(string path, int samples, Action<Textures.IImageRows> write, CancellationToken cancellation)
    {
        SceneLoadResult load = SceneLoader.Load(path, scene =>
        {
            double scale = Math.Min((double)ThumbnailWidth / scene.Render.Width, (double)ThumbnailHeight / scene.Render.Height);
            return scene with
            {
                Render = scene.Render with
                {
                    Width = Math.Max(1, (int)(scene.Render.Width * scale)),
                    Height = Math.Max(1, (int)(scene.Render.Height * scale)),
                    SamplesPerPixel = samples,
                },
            };
        });
        if (load.Scene is not { } scene)
        {
            throw new SessionException($"{Path.GetFileName(path)} cannot be rendered: {string.Join("; ", load.Diagnostics.Select(d => d.Message))}");
        }

        Film film = new(scene.Render.Width, scene.Render.Height, FilmPlane.Needed(scene.Render.Integrator, halves: true));
        RenderOptions options = new() { Threads = 1 };
        if (new RTracer(scene, options).Render(film, cancellation: cancellation).Cancelled)
        {
            throw new OperationCanceledException(cancellation);
        }

        Textures.IImageRows picture = new Denoising(scene, options).Denoise(film, null)?.Picture ?? (Textures.IImageRows)film;
        write(new ImageWriteOptions().For(scene.Render).Shown(picture));
    }

    private static string Fingerprint(string path)
    {
        using IncrementalHash hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        hash.AppendData(File.ReadAllBytes(path));
        hash.AppendData(typeof(RTracer).Module.ModuleVersionId.ToByteArray());
        hash.AppendData(typeof(Gallery).Module.ModuleVersionId.ToByteArray());
        hash.AppendData([ThumbnailSamples]);
        return Convert.ToHexStringLower(hash.GetHashAndReset());
    }

    private void Keep(string path, byte[] png)
    {
        try
        {
            PrivateFile.Write(path, png);
            foreach (FileInfo old in new DirectoryInfo(_folders.Thumbnails).GetFiles("*.png").OrderByDescending(f => f.LastWriteTimeUtc).Skip(MostKept))
            {
                old.Delete();
            }
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // It is made again the next time.
        }
    }

    private IEnumerable<GalleryGroup> FindGroups(string folder)
    {
        (string Folder, string Title)[] known =
            [("gallery", "Gallery"), ("primer", "Primer"), ("report", "The report's scenes"), ("meshes", "Meshes and motion")];
        IEnumerable<(string Folder, string Title)> others = Directory.EnumerateDirectories(folder).Select(d => Path.GetFileName(d))
            .Where(d => d != "broken" && !d.StartsWith('.') && !known.Any(k => k.Folder == d)).Order(StringComparer.Ordinal).Select(d => (d, Words(d)));
        foreach ((string name, string title) in known.Concat(others).Append(("", "More")))
        {
            GalleryItem[] items = [.. Items(folder, name)];
            if (items.Length > 0)
            {
                yield return new(title, items);
            }
        }
    }

    private IEnumerable<GalleryItem> Items(string folder, string group)
    {
        string within = Path.Combine(folder, group);
        foreach (string path in Directory.Exists(within) ? Directory.GetFiles(within, "*.json").Order(StringComparer.Ordinal) : Enumerable.Empty<string>())
        {
            string file = Path.GetFileName(path);
            if (!file.EndsWith(".schema.json", StringComparison.Ordinal))
            {
                string id = group.Length > 0 ? $"{group}/{file}" : file;
                _paths.Add(id, path);
                yield return new(id, Words(Path.GetFileNameWithoutExtension(file).TrimStart("0123456789-".ToCharArray())), Summary(path));
            }
        }
    }

    private static string Words(string name)
    {
        string words = string.Concat(name.Select((c, i) => c == '-' ? " " : i > 0 && char.IsAsciiDigit(c) && char.IsAsciiLetter(name[i - 1]) ? $" {c}" : $"{c}"));
        return words.Length == 0 ? name : char.ToUpperInvariant(words[0]) + words[1..];
    }

    // What the comment at the head says, before it says what to look at or to try.
    private static string Summary(string path)
    {
        StringBuilder summary = new();
        foreach (string line in File.ReadLines(path).TakeWhile(l => l.StartsWith("//", StringComparison.Ordinal)).Take(20))
        {
            string words = line[2..].Trim();
            if (words.StartsWith("Look at:", StringComparison.Ordinal) || words.StartsWith("Try:", StringComparison.Ordinal))
            {
                break;
            }

            summary.Append(summary.Length > 0 ? " " : "").Append(words);
        }

        return summary.ToString();
    }
}

/// <summary>Shipped scenes that belong together.</summary>
/// <param name="Title">The title of the group.</param>
/// <param name="Items">The scenes.</param>
public sealed record GalleryGroup(string Title, IReadOnlyList<GalleryItem> Items);

/// <summary>A shipped scene.</summary>
/// <param name="Id">The identifier by which it is requested.</param>
/// <param name="Name">The name.</param>
/// <param name="Summary">A description of the scene, from the comment at its head.</param>
public sealed record GalleryItem(string Id, string Name, string Summary);

/// <summary>Finds the folder of the scenes that come with the program.</summary>
public static class ScenesFolder
{
    // What no other folder of that name has.
    private const string Mark = "raytracer.schema.json";

    /// <summary>The folder "scenes" beside or above the program, or else the current folder; null where there is none.</summary>
    public static string? Find() => new[] { AppContext.BaseDirectory, Environment.CurrentDirectory }
        .SelectMany(Upwards)
        .Select(f => Path.Combine(f, "scenes"))
        .FirstOrDefault(f => File.Exists(Path.Combine(f, Mark)));

    private static IEnumerable<string> Upwards(string folder)
    {
        for (DirectoryInfo? at = new(folder); at is not null; at = at.Parent)
        {
            yield return at.FullName;
        }
    }
}
