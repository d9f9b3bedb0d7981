-- | The command line: its grammar, and the scene it asks for.
module BlackHole.Cli.Options
  ( Command (..),
    RenderOptions (..),
    Parsed (..),
    parseArguments,
    resolveScene,
  )
where

import BlackHole.Cli.Photon (PhotonOptions, photonOptions)
import BlackHole.Cli.Rays (RaysOptions, raysOptions)
import BlackHole.Cli.Read
import BlackHole.Cli.SelfTest (SelfTestOptions, selfTestOptions)
import BlackHole.Light.Display
import BlackHole.Physics.Angle
import BlackHole.Physics.Observer
import BlackHole.Physics.Spacetime
import BlackHole.Scene.Camera
import BlackHole.Scene.Disk
import BlackHole.Scene.Preset
import BlackHole.Scene.Scene
import BlackHole.Scene.Shifts
import BlackHole.Scene.Sky
import BlackHole.Scene.Validate
import BlackHole.Vector.XYZ (XYZ (..))
import Data.List (intercalate)
import Data.Maybe (fromMaybe, isJust)
import Data.Word (Word64)
import Options.Applicative
import Options.Applicative.Help (renderHelp, unChunk)
import System.Exit (ExitCode (..))

-- | What the program is asked to do.
data Command
  = -- | Render one picture.
    Render RenderOptions
  | -- | Report on one light path.
    Photon PhotonOptions
  | -- | Draw the fan of light paths.
    Rays RaysOptions
  | -- | Hold the program's numbers against known ones.
    SelfTest SelfTestOptions
  deriving (Eq, Show)

-- | The options of @blackhole render@; 'Nothing' keeps the preset's value.
data RenderOptions = RenderOptions
  { renderPreset :: !(Maybe String),
    renderWidth :: !(Maybe Int),
    renderHeight :: !(Maybe Int),
    renderFieldOfView :: !(Maybe Double),
    renderDistance :: !(Maybe Double),
    renderInclination :: !(Maybe Double),
    renderAzimuth :: !(Maybe Double),
    renderRoll :: !(Maybe Double),
    renderCamera :: !(Maybe XYZ),
    renderLookAt :: !(Maybe XYZ),
    renderObserver :: !(Maybe Observer),
    renderNoGravity :: !Bool,
    renderIntegrator :: !(Maybe Integrator),
    renderStep :: !(Maybe Double),
    renderNoDisk :: !Bool,
    renderDiskInner :: !(Maybe Double),
    renderDiskOuter :: !(Maybe Double),
    renderDiskThickness :: !(Maybe Double),
    renderDiskOpacity :: !(Maybe Double),
    renderTemperature :: !(Maybe Double),
    renderDoppler :: !(Maybe Bool),
    renderRedshift :: !(Maybe Bool),
    renderSky :: !(Maybe Sky),
    renderDebugTextures :: !Bool,
    renderSamples :: !(Maybe Int),
    renderExposure :: !(Maybe Double),
    renderToneMap :: !(Maybe ToneMap),
    renderSeed :: !(Maybe Word64),
    renderThreads :: !(Maybe Int),
    renderPixel :: !(Maybe (Int, Int)),
    renderOutput :: !FilePath
  }
  deriving (Eq, Show)

-- | The outcome of reading the command line.
data Parsed
  = -- | Do this.
    Run Command
  | -- | Print this on standard output; nothing else was asked for.
    Inform String
  | -- | One line that says what is wrong with the arguments.
    Misused String
  deriving (Eq, Show)

-- | Read the arguments, given the program's version line.
parseArguments :: String -> [String] -> Parsed
parseArguments version arguments =
  case execParserPure (prefs (columns 100)) (commandLine version) arguments of
    Success request -> Run request
    CompletionInvoked _ -> Misused "completion scripts are not available"
    Failure failure -> case execFailure failure "blackhole" of
      (text, ExitSuccess, width) -> Inform (renderHelp width text)
      (text, ExitFailure _, _) -> Misused (oneLine text)
  where
    oneLine = unwords . words . maybe "unknown arguments" show . unChunk . helpError

commandLine :: String -> ParserInfo Command
commandLine version =
  info (commands <**> versionOption <**> helper) $
    fullDesc
      <> progDesc "Physically exact pictures of a black hole."
      <> footer "Example: blackhole render --width 1280 -o hole.png"
  where
    commands =
      hsubparser $
        command
          "render"
          ( info (Render <$> renderOptions) $
              progDesc "Render one picture to a PNG file."
                <> footer "Example: blackhole render --width 1280 --inclination 75 --fov 40 -o hole.png"
          )
          <> command
            "photon"
            ( info (Photon <$> photonOptions) $
                progDesc "Report on one light path: where it goes and what it meets. Lengths in Schwarzschild radii, angles in radians."
                  <> footer "Examples: blackhole photon --impact 2.65 --json; blackhole photon --distance 20 --inclination 80 --psi 10 --eta -90"
            )
          <> command
            "rays"
            ( info (Rays <$> raysOptions) $
                progDesc "Draw parallel light rays on their way around the hole, as SVG or PNG."
                  <> footer "Example: blackhole rays --rays 41 -o rays.svg"
            )
          <> command
            "selftest"
            ( info (SelfTest <$> selfTestOptions) $
                progDesc "Hold the program's numbers against known ones, in a few seconds. The exit code is 0 only if all of them are right."
            )
    versionOption =
      infoOption version (long "version" <> help "Print the version and stop")

renderOptions :: Parser RenderOptions
renderOptions =
  RenderOptions
    <$> setting (strOption (long "preset" <> metavar "NAME" <> help ("Scene to start from: " ++ intercalate ", " presetNames ++ " (default: default)")))
    <*> setting (option wholeNumber (long "width" <> metavar "PIXELS" <> help "Width of the picture"))
    <*> setting (option wholeNumber (long "height" <> metavar "PIXELS" <> help "Height of the picture (default: 9/16 of the width)"))
    <*> setting (option number (long "fov" <> metavar "DEGREES" <> help "Angle of view across the width, above 0 and below 180"))
    <*> setting (option number (long "distance" <> metavar "R" <> help "Camera's distance from the hole in Schwarzschild radii"))
    <*> setting (option number (long "inclination" <> metavar "DEGREES" <> help "Camera's angle from the disk's axis: 0 above it, 90 in its plane"))
    <*> setting (option number (long "azimuth" <> metavar "DEGREES" <> help "Camera's angle around the disk's axis"))
    <*> setting (option number (long "roll" <> metavar "DEGREES" <> help "Turn the camera clockwise about its line of sight"))
    <*> setting (option vector (long "camera" <> metavar "X,Y,Z" <> help "Camera's place instead of the three above; the disk's axis is +y"))
    <*> setting (option vector (long "look-at" <> metavar "X,Y,Z" <> help "Point the camera looks at, with --camera (default: the hole)"))
    <*> setting (option (named "an observer" [(observerName o, o) | o <- [minBound ..]]) (long "observer" <> metavar "WHO" <> help "Who looks: static, orbiting, falling, or coordinate (the report's)"))
    <*> toggle (long "no-gravity" <> help "Straight rays, and a black ball for the hole")
    <*> setting (option (named "an integrator" [(integratorName i, i) | i <- [minBound ..]]) (long "integrator" <> metavar "NAME" <> help "How light is followed: exact (closed-form orbits) or leapfrog"))
    <*> setting (option number (long "step" <> metavar "L" <> help "The leapfrog's base length in Schwarzschild radii"))
    <*> toggle (long "no-disk" <> help "Leave the gas out")
    <*> setting (option number (long "disk-inner" <> metavar "R" <> help "Inner radius of the gas in Schwarzschild radii"))
    <*> setting (option number (long "disk-outer" <> metavar "R" <> help "Outer radius of the gas in Schwarzschild radii"))
    <*> setting (option number (long "disk-thickness" <> metavar "W" <> help "Height in Schwarzschild radii at which the gas has thinned to 1/e"))
    <*> setting (option number (long "disk-opacity" <> metavar "TAU" <> help "Optical depth of one thickness of dense gas"))
    <*> setting (option number (long "temperature" <> metavar "KELVIN" <> help "Temperature of the gas where it is hottest"))
    <*> setting (option onOff (long "doppler" <> metavar "on|off" <> help "Show the shifts by the gas's motion"))
    <*> setting (option onOff (long "redshift" <> metavar "on|off" <> help "Show the shifts by gravity"))
    <*> setting (option (named "a sky" skies) (long "sky" <> metavar "NAME" <> help "What lies behind: noise (stars), grid, uniform, or none"))
    <*> toggle (long "debug-textures" <> help "Parity checks instead of gas and sky")
    <*> setting (option wholeNumber (long "samples" <> metavar "N" <> help "Rays per pixel"))
    <*> setting (option number (long "exposure" <> metavar "STOPS" <> help "Brighter (+) or darker (-) by powers of two"))
    <*> setting (option (named "a tone map" [(toneMapName t, t) | t <- [minBound ..]]) (long "tone-map" <> metavar "NAME" <> help "How bright light is brought into range: none or film"))
    <*> setting (option seedNumber (long "seed" <> metavar "N" <> help "Seed of gas, stars and sampling, from 0 to 2^64 - 1"))
    <*> setting (option wholeNumber (long "threads" <> metavar "N" <> help "Workers (default: one per core); the picture is the same for any number"))
    <*> setting (option pixelPlace (long "pixel" <> metavar "X,Y" <> help "Explain the colour of one pixel instead of rendering; 0,0 is the top left"))
    <*> settingOr "blackhole.png" (strOption (long "output" <> short 'o' <> metavar "FILE" <> help "PNG file to write (default: blackhole.png)"))
  where
    onOff = named "on or off" [("on", True), ("off", False)]
    skies = [(skyName s, s) | s <- [SkyNoise defaultStars, SkyGrid, SkyUniform 1, SkyNone]]

-- | The scene that the options ask for, checked, or everything that is wrong
-- with it (at least one problem).
resolveScene :: RenderOptions -> Either [Problem] Scene
resolveScene options = case (findPreset presetName, clashes) of
  (Nothing, _) -> Left [Problem "--preset" presetName known]
  (_, _ : _) -> Left clashes
  (Just preset, []) ->
    let scene = applyOptions options preset
     in case validateScene scene of
          [] -> Right scene
          problems -> Left problems
  where
    presetName = fromMaybe "default" (renderPreset options)
    known =
      "a preset"
        ++ maybe "" (\n -> " (did you mean " ++ n ++ "?)") (nearest presetName presetNames)
        ++ "; there are: "
        ++ intercalate ", " presetNames
    clashes =
      [ Problem "--camera" "together with --distance, --inclination or --azimuth" "one way to place the camera; choose either"
        | isJust (renderCamera options) || isJust (renderLookAt options),
          any (isJust . ($ options)) [renderDistance, renderInclination, renderAzimuth]
      ]

-- | A preset with the given options in the place of its own values.
applyOptions :: RenderOptions -> Scene -> Scene
applyOptions options preset =
  preset
    { scenePicture = Picture width height,
      sceneCamera =
        Camera
          { cameraPose = pose,
            cameraRoll = maybe (cameraRoll camera) Degrees (renderRoll options),
            cameraFieldOfView = maybe (cameraFieldOfView camera) Degrees (renderFieldOfView options)
          },
      sceneObserver = given sceneObserver renderObserver,
      sceneSpacetime = if renderNoGravity options then Flat else sceneSpacetime preset,
      sceneIntegrator = given sceneIntegrator renderIntegrator,
      sceneStep = given sceneStep renderStep,
      sceneDisk = if renderNoDisk options then Nothing else disk <$> sceneDisk preset,
      sceneSky = given sceneSky renderSky,
      sceneShifts =
        Shifts
          (fromMaybe (shiftsDoppler shifts) (renderDoppler options))
          (fromMaybe (shiftsGravity shifts) (renderRedshift options)),
      sceneDebugTextures = renderDebugTextures options || sceneDebugTextures preset,
      sceneSamples = given sceneSamples renderSamples,
      sceneExposure = maybe (sceneExposure preset) Exposure (renderExposure options),
      sceneToneMap = given sceneToneMap renderToneMap,
      sceneSeed = given sceneSeed renderSeed
    }
  where
    given :: (Scene -> a) -> (RenderOptions -> Maybe a) -> a
    given field = fromMaybe (field preset) . ($ options)
    camera = sceneCamera preset
    shifts = sceneShifts preset
    width = fromMaybe (pictureWidth (scenePicture preset)) (renderWidth options)
    height = case (renderHeight options, renderWidth options) of
      (Just h, _) -> h
      (Nothing, Just w) | w > 0 -> max 1 (round (fromIntegral w * 9 / 16 :: Double))
      _ -> pictureHeight (scenePicture preset)
    pose = case (renderCamera options, renderLookAt options, cameraPose camera) of
      (Just place, target, _) -> LookAt place (fromMaybe (XYZ 0 0 0) target)
      (Nothing, Just target, old) -> LookAt (posePosition old) target
      (Nothing, Nothing, old) -> aroundFrom old
    -- An angle or distance given for a preset that stands at a place moves it
    -- from there.
    aroundFrom old
      | all (null . ($ options)) [renderDistance, renderInclination, renderAzimuth] = old
      | otherwise = case spherical old of
        (r, i, a) ->
          Around
            (fromMaybe r (renderDistance options))
            (maybe i Degrees (renderInclination options))
            (maybe a Degrees (renderAzimuth options))
    spherical (Around r i a) = (r, i, a)
    spherical (LookAt (XYZ x y z) _) =
      let rho = sqrt (x * x + z * z)
       in ( sqrt (rho * rho + y * y),
            toDegrees (Radians (atan2 rho y)),
            toDegrees (Radians (atan2 z x))
          )
    disk d =
      d
        { diskInnerRadius = fromMaybe (diskInnerRadius d) (renderDiskInner options),
          diskOuterRadius = fromMaybe (diskOuterRadius d) (renderDiskOuter options),
          diskThickness = fromMaybe (diskThickness d) (renderDiskThickness options),
          diskOpacity = fromMaybe (diskOpacity d) (renderDiskOpacity options),
          diskColour = maybe (diskColour d) BlackBody (renderTemperature options)
        }
