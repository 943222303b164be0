using System.Diagnostics;
using System.Globalization;

namespace RayTracer.Session;

/// <summary>Videos, which are made of frames by <c>ffmpeg</c>, where it is installed.</summary>
internal static class VideoFile
{
    /// <summary>Behind a video's name, the name of the folder that keeps its frames while they are rendered: a stopped job resumes with them.</summary>
    public const string FramesEnding = ".frames";

    private static readonly string[] s_endings = [".mp4", ".mov", ".mkv", ".webm"];
    private static readonly Lazy<string?> s_program = new(() => Find(Environment.GetEnvironmentVariable("PATH") ?? ""));

    /// <summary>The program's file; null where there is none.</summary>
    public static string? Program => s_program.Value;

    /// <summary>Returns whether a file is a video.</summary>
    public static bool IsNamed(string path) => s_endings.Contains(Path.GetExtension(path).ToLowerInvariant());

    /// <summary>Looks for the program in folders that are listed as in the variable PATH.</summary>
    public static string? Find(string folders) => folders.Split(Path.PathSeparator, StringSplitOptions.RemoveEmptyEntries)
        .Where(Path.IsPathFullyQualified).Select(f => Path.Combine(f, OperatingSystem.IsWindows() ? "ffmpeg.exe" : "ffmpeg")).FirstOrDefault(File.Exists);

    /// <summary>Makes a video of PNGs that are named by their numbers of seven digits.</summary>
    /// <param name="program">The program.</param>
    /// <param name="folder">The folder of the frames.</param>
    /// <param name="first">The number of the first.</param>
    /// <param name="rate">The frames a second.</param>
    /// <param name="path">The video, which is replaced when it is complete.</param>
    /// <param name="cancellation">Ends the work.</param>
    /// <exception cref="SessionException">The program cannot do it.</exception>
    public static void Make(string program, string folder, int first, double rate, string path, CancellationToken cancellation)
    {
        string partial = Path.Combine(folder, "video" + Path.GetExtension(path));

        // Sizes are made even, as most players need, and colours are those of most players.
        string[] words =
        [
            "-y", "-loglevel", "error", "-framerate", rate.ToString("R", CultureInfo.InvariantCulture), "-start_number", first.ToString(CultureInfo.InvariantCulture),
            "-i", Path.Combine(folder.Replace("%", "%%", StringComparison.Ordinal), "%07d.png"), "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", partial,
        ];
        using Process process = Process.Start(new ProcessStartInfo(program, words) { UseShellExecute = false, RedirectStandardError = true, RedirectStandardInput = true })
            ?? throw new SessionException($"{program} cannot be started.");
        using CancellationTokenRegistration end = cancellation.Register(() => process.Kill(entireProcessTree: true));
        process.StandardInput.Close();
        string complaint = process.StandardError.ReadToEnd();
        process.WaitForExit();
        cancellation.ThrowIfCancellationRequested();
        if (process.ExitCode != 0)
        {
            throw new SessionException($"ffmpeg could not make the video; the frames are in '{folder}': {complaint.Trim().Split('\n')[^1]}");
        }

        File.Move(partial, path, overwrite: true);
    }
}
