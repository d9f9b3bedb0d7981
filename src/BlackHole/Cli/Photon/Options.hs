-- | The options of @blackhole photon@, and the light path that they describe.
module BlackHole.Cli.Photon.Options
  ( PhotonOptions (..),
    photonOptions,
    PhotonTask (..),
    Method (..),
    resolvePhoton,
  )
where

import BlackHole.Cli.Check
import BlackHole.Cli.Json (showDouble)
import BlackHole.Cli.Read
import BlackHole.Numeric.Angle
import BlackHole.Scene.Problem (Problem (..))
import BlackHole.Scene.Scene (Integrator (..), integratorName)
import qualified BlackHole.Spacetime.Follow as Follow
import BlackHole.Spacetime.Kerr.Landmarks (Spin, spin)
import BlackHole.Spacetime.Kerr.Sight
import BlackHole.Spacetime.Observer (Observer (..), kerrMotion, observerName, observerRange)
import BlackHole.Spacetime.Schwarzschild.StepRule (StepRule (..), reportStepRule)
import BlackHole.Spacetime.Schwarzschild.Trajectory
import BlackHole.Spacetime.Types (Spacetime (Kerr))
import Data.Maybe (fromMaybe)
import Options.Applicative

-- | The options of @blackhole photon@.
data PhotonOptions = PhotonOptions
  { photonImpact :: !(Maybe Double),
    photonDistance :: !(Maybe Double),
    photonInclination :: !(Maybe Double),
    photonSpin :: !(Maybe Double),
    photonObserver :: !Observer,
    photonPsi :: !(Maybe Double),
    photonEta :: !(Maybe Double),
    photonIntegrator :: !Integrator,
    photonStep :: !(Maybe Double),
    photonJson :: !Bool,
    photonPath :: !(Maybe FilePath),
    -- | Do not report that the path is written.
    photonQuiet :: !Bool
  }
  deriving (Eq, Show)

-- | Their parser.
photonOptions :: Parser PhotonOptions
photonOptions =
  PhotonOptions
    <$> setting
      ( option
          number
          ( long "impact" <> metavar "B"
              <> help "Follow light from infinity with this impact parameter, in r_s"
          )
      )
    <*> setting
      ( option
          number
          ( long "distance" <> metavar "R"
              <> help
                ( "Distance of the camera from the hole in r_s, with --psi (default: "
                    ++ showDouble standardDistance
                    ++ ")"
                )
          )
      )
    <*> setting
      ( option
          number
          ( long "inclination" <> metavar "DEGREES"
              <> help
                ( "Angle between the disk's axis and the camera, or the direction that the light \
                  \goes to (default: "
                    ++ showDouble standardInclination
                    ++ ")"
                )
          )
      )
    <*> setting
      ( option
          number
          ( long "spin" <> metavar "A"
              <> help
                "Spin of the hole, from -1 to 1, positive if it turns with the disk (default: 0)"
          )
      )
    <*> settingOr
      Static
      ( option
          (named "an observer" [(observerName o, o) | o <- movements])
          ( long "observer" <> metavar "NAME" <> completeWith (map observerName movements)
              <> help
                "Motion of the observer with --psi: static, zamo, orbiting, counter-orbiting or \
                \falling (default: static)"
          )
      )
    <*> setting
      ( option
          number
          ( long "psi" <> metavar "DEGREES"
              <> help
                "Follow the line of sight at this angle from the direction of the hole's centre"
          )
      )
    <*> setting
      ( option
          number
          ( long "eta" <> metavar "DEGREES"
              <> help
                ( "Position angle of the path about the hole's centre, from right towards up \
                  \(default: "
                    ++ showDouble standardEta
                    ++ ")"
                )
          )
      )
    <*> settingOr
      Exact
      ( option
          (named "an integrator" [(integratorName i, i) | i <- [minBound ..]])
          ( long "integrator" <> metavar "NAME" <> completeWith (map integratorName [minBound ..])
              <> help
                "How to follow the light: exact (closed form), table (as render does by default) \
                \or leapfrog; the latter two with their errors (default: exact)"
          )
      )
    <*> setting
      ( option
          number
          ( long "step" <> metavar "L"
              <> help "Base step length of the leapfrog in r_s (default: 0.1)"
          )
      )
    <*> toggle (long "json" <> help "Print JSON instead of a table")
    <*> setting
      ( strOption
          ( long "path" <> metavar "FILE.csv" <> action "file"
              <> help "Also write the points of the path: swept angle, r, x, y, z"
          )
      )
    <*> toggle (long "quiet" <> short 'q' <> help "Do not report that the path is written")

-- The observers whose directions of sight are directions in a frame of their own.
movements :: [Observer]
movements = filter (/= Coordinate) [minBound ..]

-- The camera of the default scene, and a line of sight to the right of the hole.
standardDistance, standardInclination, standardEta :: Double
standardDistance = 30
standardInclination = 82
standardEta = 0

-- | A light path, and how to follow it.
data PhotonTask
  = PhotonTask !Trajectory !Method
  | -- | Around a rotating hole, or seen by an observer in motion.
    RotatingTask !Follow.Method !Spin !Azimuth !LightRay

-- | The ways to follow it.
data Method
  = ClosedForm
  | Leapfrog !StepRule
  | -- | The same path from the renderer's table.
    FromTable !Trajectory

-- | The path that the options describe, or all their mistakes (at least one).
resolvePhoton :: PhotonOptions -> Either [Problem] PhotonTask
resolvePhoton options = case photonSpin options of
  Just s | s /= 0 -> resolveRotating options s
  _ | photonObserver options /= Static -> resolveRotating options 0
  _ -> resolvePlanar options

-- | The path of a line of sight around a hole of any spin, of an observer in any motion.
resolveRotating :: PhotonOptions -> Double -> Either [Problem] PhotonTask
resolveRotating options s = case (problems, ray) of
  ([], Right found) -> Right found
  ([], Left problem) -> Left [problem]
  _ -> Left problems
  where
    problems =
      checkNumber "--spin" (\v -> abs v < 1) "a spin above -1 and below 1" s
        ++ [Mistake "--impact" ("applies only " ++ planar) | Just _ <- [photonImpact options]]
        ++ [ Mistake "--psi" "missing; give --psi DEGREES for a line of sight"
             | Nothing <- [photonPsi options],
               Nothing <- [photonImpact options]
           ]
        ++ [ Mistake "--integrator" ("leapfrog applies only " ++ planar)
             | photonIntegrator options == Leapfrogging
           ]
        ++ [ Mistake
               "--step"
               (showDouble l ++ " has no effect; it applies only with --integrator leapfrog")
             | Just l <- [photonStep options]
           ]
        ++ checkNumber
          "--distance"
          (\r -> r > 0 && r <= 1e6)
          "a distance above 0 and up to 1e6 (Schwarzschild radii)"
          distance
        ++ foldMap psiProblems (photonPsi options)
        ++ sightProblems inclination eta
        ++ pathNameProblems options
    planar
      | s /= 0 = "without --spin, where every path lies in a plane"
      | otherwise = "to an observer at rest (--observer static)"
    distance = fromMaybe standardDistance (photonDistance options)
    inclination = fromMaybe standardInclination (photonInclination options)
    psi = fromMaybe 0 (photonPsi options)
    eta = fromMaybe standardEta (photonEta options)
    observer = photonObserver options
    direction =
      Direction
        (negate (cosine psi))
        (negate (sine psi * sine eta))
        (sine psi * cosine eta)
    sine = sineOfDegrees . Degrees
    cosine = cosineOfDegrees . Degrees
    ray = case (spin s, kerrMotion observer) of
      (Just hole, Just motion) ->
        maybe
          (Left (noLight hole))
          (Right . RotatingTask method hole (azimuth motion))
          ( lightRay
              hole
              (Place distance polarAngle)
              motion
              direction
          )
      _ -> Left (Problem "--spin" (showDouble s) "a spin above -1 and below 1")
    polarAngle = inRadians (toRadians (Degrees inclination))
    azimuth motion = if motion == InFreeFall then Ingoing 0 else BoyerLindquist 0
    method = if photonIntegrator options == Tabulated then Follow.ByTable else Follow.InClosedForm
    noLight hole
      | observer == Falling =
        Problem
          "--psi"
          (showDouble psi)
          "a direction from which light reaches this observer inside the horizon"
      | otherwise =
        Problem "--distance" (showDouble distance) $
          "a distance above " ++ showDouble (observerRange (Kerr hole) observer polarAngle)
            ++ ( case observer of
                   Static -> ", outside the ergosphere"
                   Zamo -> ", outside the horizon"
                   _ -> ", where a circular orbit is slower than light"
               )
            ++ " (Schwarzschild radii); "
            ++ ( if observer == Zamo
                   then "falling observers can be closer"
                   else "zamo and falling observers can be closer"
               )

-- | The path around a hole that does not rotate.
resolvePlanar :: PhotonOptions -> Either [Problem] PhotonTask
resolvePlanar options = case (problems, trajectory, method) of
  ([], Just path, Just way) -> Right (PhotonTask path way)
  _ -> Left problems
  where
    problems =
      startProblems ++ sightProblems inclination eta ++ methodProblems ++ pathNameProblems options
    (startProblems, trajectory) = case (photonImpact options, photonPsi options) of
      (Just b, Nothing)
        | Nothing <- photonDistance options ->
          ( checkNumber
              "--impact"
              (\v -> v >= 0 && v <= 1e6)
              "a length from 0 to 1e6 (Schwarzschild radii)"
              b,
            Just (trajectoryFromInfinity sight b)
          )
      (Just _, _) -> ([Mistake "--impact" "cannot be combined with --psi or --distance"], Nothing)
      (Nothing, Nothing) ->
        ( [ Mistake
              "--psi"
              "missing; give --psi DEGREES for a line of sight, or --impact B for light from \
              \infinity"
          ],
          Nothing
        )
      (Nothing, Just angle) ->
        ( checkNumber
            "--distance"
            (\r -> r > 1 && r <= 1e6)
            "a distance above 1 and up to 1e6 (Schwarzschild radii)"
            distance
            ++ psiProblems angle,
          trajectoryFromCamera sight distance (toRadians (Degrees angle))
        )
    distance = fromMaybe standardDistance (photonDistance options)
    inclination = fromMaybe standardInclination (photonInclination options)
    eta = fromMaybe standardEta (photonEta options)
    sight = Sight (toRadians (Degrees inclination)) (toRadians (Degrees eta))
    (methodProblems, method) = case (photonIntegrator options, photonStep options) of
      (Leapfrogging, Just l) ->
        ( checkNumber
            "--step"
            (\v -> v >= 1e-5 && v <= 10)
            "a length from 0.00001 to 10 (Schwarzschild radii)"
            l,
          Just (Leapfrog (ReportSteps l reportWidth))
        )
      (_, Just l) ->
        ( [ Mistake
              "--step"
              (showDouble l ++ " has no effect; it applies only with --integrator leapfrog")
          ],
          Nothing
        )
      (Leapfrogging, Nothing) -> ([], Just (Leapfrog reportStepRule))
      (Exact, Nothing) -> ([], Just ClosedForm)
      (Tabulated, Nothing) -> case photonPsi options of
        Just angle ->
          ([], FromTable <$> trajectoryFromTable sight distance (toRadians (Degrees angle)))
        Nothing ->
          ( [ Mistake
                "--integrator"
                "table applies only with --psi; it holds the paths that start at the camera's \
                \distance"
            ],
            Nothing
          )
    -- The thickness of the disk in the step rule of the design report.
    reportWidth = case reportStepRule of
      ReportSteps _ w -> w
      EqualSteps _ -> 0.01

pathNameProblems :: PhotonOptions -> [Problem]
pathNameProblems options =
  [Problem "--path" "an empty name" "the name of a file" | photonPath options == Just ""]

-- | The problems of an angle ψ in degrees.
psiProblems :: Double -> [Problem]
psiProblems =
  checkNumber
    "--psi"
    (\a -> a >= 0 && a <= 180)
    "an angle from 0 to 180 (degrees from the direction of the hole's centre)"

-- | The problems of an inclination and an angle η in degrees.
sightProblems :: Double -> Double -> [Problem]
sightProblems inclination eta =
  checkNumber
    "--inclination"
    (\i -> i >= 0 && i <= 180)
    "an angle from 0 to 180 (degrees from the disk's axis)"
    inclination
    ++ checkNumber
      "--eta"
      (\a -> abs a <= 360)
      "an angle from -360 to 360 (degrees from right towards up)"
      eta
