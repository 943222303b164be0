using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>The panes and tabs that are shown.</summary>
internal sealed class Layout : Observable
{
    private static readonly string[] LeftNames = ["scene", "gallery", "files"];
    private static readonly string[] DockNames = ["source", "paths", "maps", "convergence", "times"];
    private static readonly string[] Themes = ["system", "light", "dark"];
    private int _theme;

    public bool IsLeftOpen { get; set => SetProperty(ref field, value); } = true;

    public bool IsRightOpen { get; set => SetProperty(ref field, value); } = true;

    public bool IsDockOpen { get; set => SetProperty(ref field, value); } = true;

    /// <summary>The left pane's tab.</summary>
    public int LeftTab { get; set => SetProperty(ref field, value); }

    /// <summary>The lower pane's tab.</summary>
    public int DockTab { get; set => SetProperty(ref field, value); }

    public bool ShowsConvergence => IsDockOpen && DockNames[DockTab] == "convergence";

    /// <summary>The colours: "system", "light" or "dark".</summary>
    public string Theme => Themes[_theme];

    /// <summary>The colours in words.</summary>
    public string ThemeText => SessionTexts.Of($"theme.{Theme}");

    /// <summary>Shows a tab of the left pane.</summary>
    public void OpenLeft(string tab) => (IsLeftOpen, LeftTab) = (true, Array.IndexOf(LeftNames, tab));

    /// <summary>Shows a tab of the lower pane.</summary>
    public void OpenDock(string tab) => (IsDockOpen, DockTab) = (true, Array.IndexOf(DockNames, tab));

    /// <summary>Other colours.</summary>
    public void NextTheme()
    {
        _theme = (_theme + 1) % Themes.Length;
        Report(nameof(Theme), nameof(ThemeText));
    }
}
