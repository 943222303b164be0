using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>Which panes and tabs are shown.</summary>
internal sealed class Layout : Observable
{
    private static readonly string[] LeftNames = ["scene", "gallery", "files"];
    private static readonly string[] DockNames = ["source", "paths", "maps", "convergence", "times"];
    private static readonly string[] Themes = ["system", "light", "dark"];
    private bool _isLeftOpen = true;
    private bool _isRightOpen = true;
    private bool _isDockOpen = true;
    private int _leftTab;
    private int _dockTab;
    private int _theme;

    /// <summary>Whether the left pane is shown.</summary>
    public bool IsLeftOpen
    {
        get => _isLeftOpen;
        set => Set(ref _isLeftOpen, value);
    }

    /// <summary>Whether the right pane is shown.</summary>
    public bool IsRightOpen
    {
        get => _isRightOpen;
        set => Set(ref _isRightOpen, value);
    }

    /// <summary>Whether the lower pane is shown.</summary>
    public bool IsDockOpen
    {
        get => _isDockOpen;
        set => Set(ref _isDockOpen, value);
    }

    /// <summary>The left pane's tab.</summary>
    public int LeftTab
    {
        get => _leftTab;
        set => Set(ref _leftTab, value);
    }

    /// <summary>The lower pane's tab.</summary>
    public int DockTab
    {
        get => _dockTab;
        set => Set(ref _dockTab, value);
    }

    /// <summary>Whether the convergence is to be seen.</summary>
    public bool ShowsConvergence => _isDockOpen && DockNames[_dockTab] == "convergence";

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
        Tell(nameof(Theme));
        Tell(nameof(ThemeText));
    }
}
