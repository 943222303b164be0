using System.IO.Compression;
using RayTracer.Testing;

namespace RayTracer.Benchmarks.Embree;

/// <summary>A file of Embree.</summary>
/// <param name="Path">The library.</param>
/// <param name="Major">The version of its interface, 3 or 4.</param>
/// <param name="Label">Where it comes from.</param>
internal sealed record EmbreeLibrary(string Path, int Major, string Label)
{
    private const string Debian = "/usr/lib/x86_64-linux-gnu";

    /// <summary>
    /// Finds Embree 4 in the folder PEERS_SITE or, where that is not set, in the wheel in shared/peers; otherwise what Debian has
    /// installed.
    /// </summary>
    /// <param name="temporary">Receives what is unpacked.</param>
    /// <returns>Null where there is none.</returns>
    public static EmbreeLibrary? Find(string temporary)
    {
        string? site = Environment.GetEnvironmentVariable("PEERS_SITE");
        EmbreeLibrary? peer = site is null ? Unpack(temporary) : In(System.IO.Path.Combine(site, "embreex.libs"), 4, site);
        return peer ?? In(Debian, 4, "Debian's libembree-dev (a fallback)") ?? In(Debian, 3, "Debian's libembree-dev (a fallback: an older version)");
    }

    private static EmbreeLibrary? In(string folder, int major, string label) =>
        Directory.Exists(folder) && Directory.GetFiles(folder, $"libembree{major}*.so*").Order(StringComparer.Ordinal).FirstOrDefault() is string path
            ? new(path, major, label)
            : null;

    // A wheel is a ZIP file; only the native libraries are wanted.
    private static EmbreeLibrary? Unpack(string temporary)
    {
        string? wheel = ProjectFolder.Found is null || ProjectFolder.Shared("peers", "wheels") is not string wheels
            ? null
            : Directory.GetFiles(wheels, "embreex-*.whl").Order(StringComparer.Ordinal).LastOrDefault();
        if (wheel is null)
        {
            return null;
        }

        using ZipArchive archive = ZipFile.OpenRead(wheel);
        foreach (ZipArchiveEntry entry in archive.Entries.Where(e => e.FullName.StartsWith("embreex.libs/", StringComparison.Ordinal) && e.Name.Length > 0))
        {
            entry.ExtractToFile(System.IO.Path.Combine(temporary, entry.Name));
        }

        return In(temporary, 4, System.IO.Path.GetFileName(wheel));
    }
}
