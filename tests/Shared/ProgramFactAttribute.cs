using System.Diagnostics;

namespace RayTracer.Testing;

/// <summary>A test that needs an external program, and is skipped with that reason where it is missing.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class ProgramFactAttribute : FactAttribute
{
    public ProgramFactAttribute(params string[] programs)
    {
        string? missing = programs.FirstOrDefault(program => !IsThere(program));
        if (missing is not null)
        {
            Skip = $"the program {missing} is not installed";
        }
    }

    /// <summary>Runs a program to its end; returns its exit code and what it wrote.</summary>
    public static (int ExitCode, string Output) Run(string program, params string[] arguments)
    {
        var start = new ProcessStartInfo(program, arguments) { UseShellExecute = false, RedirectStandardOutput = true, RedirectStandardError = true };
        using Process process = Process.Start(start)!;
        Task<string> errors = process.StandardError.ReadToEndAsync();
        string output = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        return (process.ExitCode, output + errors.Result);
    }

    /// <summary>Whether a program of this name is on the path.</summary>
    public static bool IsThere(string program) => (Environment.GetEnvironmentVariable("PATH") ?? "")
        .Split(Path.PathSeparator)
        .Any(folder => File.Exists(Path.Combine(folder, program)) || File.Exists(Path.Combine(folder, program + ".exe")));
}

/// <summary>A test that needs ImageMagick, and is skipped where it is missing. Other programs are called <c>convert</c> too (on Windows, one for file systems).</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class ImageMagickFactAttribute : FactAttribute
{
    /// <summary>The name of its converter; null where it is missing.</summary>
    public static string? Program { get; } = new[] { "magick", "convert-im6.q16hdri", "convert-im6.q16", "convert" }.FirstOrDefault(IsImageMagick);

    public ImageMagickFactAttribute()
    {
        if (Program is null)
        {
            Skip = "ImageMagick is not installed: no program magick or convert says that it is a part of it";
        }
    }

    private static bool IsImageMagick(string program) =>
        ProgramFactAttribute.IsThere(program) && ProgramFactAttribute.Run(program, "-version").Output.StartsWith("Version: ImageMagick", StringComparison.Ordinal);
}
