using Avalonia;
using Avalonia.Controls.ApplicationLifetimes;
using Avalonia.Markup.Xaml;
using Avalonia.Styling;
using RayTracer.Desktop.ViewModels;
using RayTracer.Desktop.Views;
using RayTracer.Session;

namespace RayTracer.Desktop;

/// <summary>The program in a window of the system's own.</summary>
internal sealed class App : Application
{
    /// <summary>The session that the window shows; made before the window is.</summary>
    public static StudioSession? Session { get; set; }

    /// <summary>Returns whether a window exists.</summary>
    public static bool IsOpen { get; private set; }

    /// <inheritdoc/>
    public override void Initialize() => AvaloniaXamlLoader.Load(this);

    /// <inheritdoc/>
    public override void OnFrameworkInitializationCompleted()
    {
        if (ApplicationLifetime is IClassicDesktopStyleApplicationLifetime desktop && Session is { } session)
        {
            desktop.MainWindow = Open(session);
            IsOpen = true;
        }

        base.OnFrameworkInitializationCompleted();
    }

    /// <summary>The window of a session.</summary>
    public static MainWindow Open(StudioSession session)
    {
        MainWindow window = new();
        MainViewModel main = new(session, new WindowServices(() => window));
        main.Layout.PropertyChanged += (_, _) => Current!.RequestedThemeVariant = VariantOf(main.Layout.Theme);
        window.DataContext = main;
        window.Closed += (_, _) => main.Dispose();
        _ = main.Run();
        return window;
    }

    private static ThemeVariant VariantOf(string theme) =>
        theme switch { "light" => ThemeVariant.Light, "dark" => ThemeVariant.Dark, _ => ThemeVariant.Default };
}
