using System.Runtime.CompilerServices;
using Avalonia;
using RayTracer.Jobs;
using RayTracer.Session;

namespace RayTracer.Desktop;

/// <summary>The Studio in a window of the system's own, instead of a browser's.</summary>
internal static class Program
{
    private const int WrongUsage = 2;
    private const int InputOutput = 4;

    [STAThread]
    private static int Main(string[] args)
    {
        WideVectors.Enable(args);
        if (args.Length > 1 || (args.Length == 1 && args[0].StartsWith('-')))
        {
            Console.Error.WriteLine(SessionTexts.Of("desktop.usage"));
            return WrongUsage;
        }

        try
        {
            using StudioSession session = new();
            if (args.Length == 1)
            {
                session.Files.Open(Path.GetFullPath(args[0]));
            }

            return Start(session);
        }
        catch (Exception e) when (e is SessionException or JobException)
        {
            Console.Error.WriteLine($"error: {e.Message}");
            return InputOutput;
        }
    }

    private static int Start(StudioSession session)
    {
        AppBuilder builder;
        try
        {
            builder = Platform();
        }
        catch (Exception e) when (e is FileNotFoundException or TypeLoadException or DllNotFoundException or BadImageFormatException)
        {
            Console.Error.WriteLine(SessionTexts.Of("desktop.missing", NameOf(e)));
            return InputOutput;
        }

        try
        {
            App.Session = session;
            return builder.StartWithClassicDesktopLifetime([]);
        }
        catch (Exception e) when (!App.IsOpen)
        {
            // A system without a screen, most likely.
            Console.Error.WriteLine(SessionTexts.Of("desktop.noScreen", e.Message.TrimEnd('.')));
            return InputOutput;
        }
    }

    // A method of its own: what it names is looked for when it is called first.
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static AppBuilder Platform() => AppBuilder.Configure<App>().UsePlatformDetect();

    private static string NameOf(Exception e) =>
        e is FileNotFoundException { FileName: { } name } ? name.Split(',')[0] : e.Message.TrimEnd('.');
}
