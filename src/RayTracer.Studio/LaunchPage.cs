using System.Text;

namespace RayTracer.Studio;

/// <summary>
/// Hands the address with the secret to the browser: by a file that only the user can read, so that no command line shows it.
/// Gone when disposed of.
/// </summary>
internal sealed class LaunchPage : IDisposable
{
    private readonly string _folder;
    private bool _isGone;

    /// <summary>Writes the file.</summary>
    /// <param name="link">The address.</param>
    public LaunchPage(string link)
    {
        // On Unix, of mode 0700.
        _folder = Directory.CreateTempSubdirectory("raytracer-studio-").FullName;
        FilePath = Path.Combine(_folder, "open.html");
        FileStreamOptions options = new() { Mode = FileMode.CreateNew, Access = FileAccess.Write };
        if (!OperatingSystem.IsWindows())
        {
            options.UnixCreateMode = UnixFileMode.UserRead | UnixFileMode.UserWrite;
        }

        using FileStream stream = new(FilePath, options);
        stream.Write(Encoding.UTF8.GetBytes($"""
            <!doctype html>
            <meta charset="utf-8">
            <meta name="referrer" content="no-referrer">
            <meta http-equiv="refresh" content="0; url={link}">
            <title>Ray tracer Studio</title>

            """));
    }

    /// <summary>The file.</summary>
    public string FilePath { get; }

    /// <inheritdoc/>
    public void Dispose()
    {
        if (Interlocked.Exchange(ref _isGone, true))
        {
            return;
        }

        try
        {
            Directory.Delete(_folder, recursive: true);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // The system clears its temporary folder some day, and the secret is worth nothing after the program's end.
        }
    }
}
